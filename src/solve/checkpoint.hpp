#pragma once
#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "backend/backend.hpp"
#include "base/error.hpp"
#include "solve/result.hpp"

/// What a run has to know to go on later as if it had never stopped.
namespace ashlar {

/// Named series of numbers and texts. One is kept after every stage; one within a stage goes on from there once the
/// stage has been set up again from the one before it.
struct Checkpoint {
  int stage = 0;        ///< 0-based: the one that begins, or goes on
  bool within = false;  ///< in the middle of the stage
  std::map<std::string, std::vector<double>> numbers;
  std::map<std::string, std::vector<std::string>> texts;
};

/// Where a run goes on; nothing: it begins.
struct Restart {
  std::optional<Checkpoint> stage_start;  ///< none: the start of the first stage
  std::optional<Checkpoint> within;       ///< of the same stage
};

/// Puts values into a checkpoint or takes them from it, in the same order: one routine for both. Values of one name
/// form a series.
class Exchange {
 public:
  explicit Exchange(Checkpoint& keep) : to_(&keep), from_(keep) {}
  explicit Exchange(const Checkpoint& take) : from_(take) {}
  bool taking() const { return !to_; }

  template <class T>
  void operator()(const std::string& name, T& value) {
    if constexpr (std::is_same_v<T, std::string>) {
      next(name, value, from_.texts, to_ ? &to_->texts : nullptr);
    } else if constexpr (std::is_arithmetic_v<T>) {
      auto number = static_cast<double>(value);
      next(name, number, from_.numbers, to_ ? &to_->numbers : nullptr);
      value = static_cast<T>(number);
    } else {
      exchange(*this, name, value);
    }
  }

  /// As many numbers as `values` has.
  void series(const std::string& name, std::vector<double>& values) {
    if (to_) {
      std::vector<double>& all = to_->numbers[name];
      all.insert(all.end(), values.begin(), values.end());
      return;
    }
    const std::vector<double>& all = found(name, from_.numbers, values.size());
    std::size_t& at = taken_[name];
    std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(at), values.size(), values.begin());
    at += values.size();
  }

 private:
  template <class V>
  const std::vector<V>& found(const std::string& name, const std::map<std::string, std::vector<V>>& from,
                              std::size_t count) {
    const auto series = from.find(name);
    if (series == from.end() ? count > 0 : taken_[name] + count > series->second.size())
      throw ResourceError("the checkpoint lacks '" + name + "': it is of another version of the program");
    static const std::vector<V> none;
    return series == from.end() ? none : series->second;
  }
  template <class V>
  void next(const std::string& name, V& value, const std::map<std::string, std::vector<V>>& from,
            std::map<std::string, std::vector<V>>* to) {
    if (to) {
      (*to)[name].push_back(value);
      return;
    }
    const std::vector<V>& all = found(name, from, 1);
    value = all[taken_[name]++];
  }
  Checkpoint* to_ = nullptr;
  const Checkpoint& from_;
  std::map<std::string, std::size_t> taken_;
};

template <class T>
void exchange(Exchange& e, const std::string& name, std::vector<T>& values) {
  std::size_t count = values.size();
  e(name + ".count", count);
  values.resize(count);
  if constexpr (std::is_same_v<T, double>)
    e.series(name, values);
  else
    for (T& value : values) e(name, value);
}
template <class T>
void exchange(Exchange& e, const std::string& name, std::optional<T>& value) {
  bool has = value.has_value();
  e(name + ".given", has);
  if (!has) return value.reset();
  if (!value) value.emplace();
  e(name, *value);
}
template <class T>
void exchange(Exchange& e, const std::string& name, std::map<std::string, T>& values) {
  std::vector<std::string> keys;
  for (const auto& entry : values) keys.push_back(entry.first);
  e(name + ".key", keys);
  if (e.taking()) values.clear();
  for (const std::string& key : keys) e(name, values[key]);
}
inline void exchange(Exchange& e, const std::string& name, Vec3<double>& v) {
  for (int i = 0; i < 3; ++i) e(name, v[i]);
}

/// All bits of a field of the machine.
void exchange_field(Exchange& e, const std::string& name, Backend& backend, Field field);
void exchange(Exchange& e, const std::string& name, CrackEvent& event);
void exchange(Exchange& e, const std::string& name, EnergyBalance& energy);
void exchange(Exchange& e, const std::string& name, InitialBalance& balance);
void exchange(Exchange& e, const std::string& name, LaneTimes& lanes);
void exchange(Exchange& e, const std::string& name, LooseBlocks& loose);
void exchange(Exchange& e, const std::string& name, Dissipation<double>& lost);
void exchange(Exchange& e, const std::string& name, PhaseTime& time);
void exchange(Exchange& e, const std::string& name, StageResult& stage);
void exchange(Exchange& e, const std::string& name, HistoryTable::Row& row);

}  // namespace ashlar

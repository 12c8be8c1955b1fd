#include "solve/lane.hpp"

#include <utility>

namespace ashlar {

Lane::Lane(const std::function<std::unique_ptr<Backend>()>& make, bool beside) {
  if (beside) thread_ = std::thread([this] { serve(); });
  // A machine belongs to the thread that uses it from its making to its end.
  try {
    run([&] { backend_ = make(); });
  } catch (...) {
    close();
    throw;
  }
}

Lane::~Lane() {
  start([this] { backend_.reset(); });
  close();
}

/// Lets the thread end, when its work has.
void Lane::close() {
  {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !busy_; });
    closing_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void Lane::start(std::function<void()> work) {
  {
    const std::lock_guard lock(mutex_);
    work_ = std::move(work);
    busy_ = true;
  }
  changed_.notify_all();
  if (!beside()) do_work();
}

void Lane::wait(const std::function<void()>& meanwhile) {
  std::unique_lock lock(mutex_);
  while (!changed_.wait_for(lock, std::chrono::milliseconds(100), [&] { return !busy_; })) {
    lock.unlock();
    if (meanwhile) meanwhile();
    lock.lock();
  }
  if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
}

void Lane::serve() {
  for (;;) {
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [&] { return busy_ || closing_; });
      if (!busy_) return;
    }
    do_work();
  }
}

void Lane::do_work() {
  began_ = Clock::now();
  try {
    work_();
  } catch (...) {
    error_ = std::current_exception();
  }
  ended_ = Clock::now();
  {
    const std::lock_guard lock(mutex_);
    busy_ = false;
  }
  changed_.notify_all();
}

}  // namespace ashlar

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <map>
#include <new>

#include "base/error.hpp"
#include "cli/commands.hpp"

/// Threads that spin at every barrier slow each other badly where something else wants a core. OpenMP reads how long to
/// spin when the program is loaded, so the program starts itself once more with a short wait, unless the user has
/// chosen one.
static void wait_politely(char** words) {
  if (std::getenv("OMP_WAIT_POLICY") || std::getenv("GOMP_SPINCOUNT")) return;
  setenv("GOMP_SPINCOUNT", "1000", 1);
  execv("/proc/self/exe", words);  // comes back only where that is not possible: then the default serves
}

int main(int count, char** words) {
  wait_politely(words);
  using namespace ashlar;
  const std::map<std::string, std::function<int(const Arguments&)>> commands = {
      {"new", new_command},
      {"run", run_command},
      {"resume", resume_command},
      {"check", check_command}, {"export", export_command},   {"plot", plot_command},
      {"material", material_command},
      {"compare", compare_command},
      {"bench", bench_command}, {"info", info_command},   {"version", version_command}, {"help", help_command},
  };
  const auto say = [](const char* words) { std::fprintf(stderr, "%s\n", words); };
  try {
    const Arguments arguments = parse_arguments({words + 1, words + count});
    return commands.at(arguments.verb)(arguments);
  } catch (const UsageError& error) {
    say(error.what());
    return 2;
  } catch (const DeckError& error) {
    say(error.what());
    return 2;
  } catch (const ResourceError& error) {
    say(error.what());
    return 5;
  } catch (const std::bad_alloc&) {
    say("not enough memory");
    return 5;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error in the program: %s\n", error.what());
    return 1;
  }
}

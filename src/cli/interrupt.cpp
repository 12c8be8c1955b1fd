#include "cli/interrupt.hpp"

#include <unistd.h>

#include <atomic>
#include <csignal>

namespace ashlar {
namespace {

// Any thread may take the signal: an atomic without a lock is safe in a handler.
std::atomic<int> requests{0};
static_assert(std::atomic<int>::is_always_lock_free);

void on_signal(int) {
  if (requests.fetch_add(1) > 0) _exit(130);
}

}  // namespace

void catch_interrupts() {
  struct sigaction action = {};
  action.sa_handler = on_signal;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool interrupt_requested() { return requests.load() > 0; }

}  // namespace ashlar

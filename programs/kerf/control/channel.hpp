// The control channel of a run: who watches it and commands it from another program.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "kernel/planned_fault.hpp"
#include "parser/moves/auxiliary_axes.hpp"
#include "programs/kerf/control/endpoint.hpp"
#include "programs/kerf/control/operator.hpp"
#include "programs/kerf/exit_status.hpp"

namespace kerf::program {

// Serves all clients in a thread of its own. Commands are carried out by the thread that plans, an
// emergency stop at once. A client that does not read for a second is dropped once a megabyte waits
// for it; it keeps nobody else waiting.
//
// Where the descriptors that were handed over have come to their end, nobody can answer a wait: the
// program is stopped there.
class ControlChannel {
 public:
  struct Order {
    std::string file;         // of the program, for the greeting
    parser::Letters extra{};  // the machine's axes beside X, Y and Z
    FeedInputNumbers feed_inputs{};
    bool machine_has_inputs = false;                        // RequestExecution::Order
    ToolTable tools{};                                      // RequestExecution::Order, too
    std::function<bool(const PlannedFault&)> break_down{};  // false: nothing that can be broken
    bool others_answer = false;
    bool waits_for_start = false;
  };
  ControlChannel(ControlEndpoint endpoint, Operator& by, Order order);
  ~ControlChannel();
  ControlChannel(const ControlChannel&) = delete;
  ControlChannel& operator=(const ControlChannel&) = delete;

  // From now on commands are refused; those that came before wait for the thread that plans.
  void close();
  // What happened until then, the last words as messages of Kerf itself, and how the run ended is
  // told to all that still read, within a second; nothing follows it. Precondition: close(), and
  // nothing happens any more.
  void finish(ExitStatus status, const std::vector<ProgramMessage>& last_words);

 private:
  class Server;
  std::unique_ptr<Server> server_;
};

}  // namespace kerf::program

// SPDX-License-Identifier: MIT
// Model Context Protocol, without what carries it: one JSON-RPC message in, its answer out.
#ifndef SINEW_CLI_SERVER_HPP
#define SINEW_CLI_SERVER_HPP

#include <atomic>
#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "serve/child.hpp"
#include "serve/served_folder.hpp"
#include "serve/tools.hpp"

namespace sinew::cli {

struct ServerLimits {
  double seconds = 600;         // of a job
  unsigned jobs = 1;            // at the same time; others wait
  size_t message = 8u << 20;    // bytes
  size_t resource = 16u << 20;  // bytes of a file that is sent
};

// A process to run, as run_child().
using RunChild =
    std::function<ChildResult(const std::vector<std::string>& words, const std::string& folder, double seconds,
                              const std::atomic<bool>& cancel, const std::function<void(const std::string&)>& on_line)>;

// Calls may come from several threads.
class Server {
 public:
  Server(ServedFolder folder, ServerLimits limits, RunChild run);

  using Notify = std::function<void(const OrderedJson& message)>;
  // The answer to one message; none to notifications and answers. Progress of a call that asks for it goes to `notify`.
  std::optional<OrderedJson> answer(const std::string& message, const Notify& notify);
  // Whether a message may take long: a call of a tool.
  static bool is_call(const std::string& message);
  const ServerLimits& limits() const { return limits_; }

 private:
  struct Refusal {
    int code;
    std::string line;
  };
  using Cancel = std::shared_ptr<std::atomic<bool>>;

  OrderedJson result_of(const std::string& method, const OrderedJson& parameters, const std::string& id,
                        const Notify& notify);
  OrderedJson initialize(const OrderedJson& parameters) const;
  OrderedJson call(const OrderedJson& parameters, const std::string& id, const Notify& notify);
  OrderedJson run(const ToolRun& job, const OrderedJson& parameters, const std::atomic<bool>& cancel,
                  const Notify& notify);
  OrderedJson resources() const;
  OrderedJson resource(const OrderedJson& parameters) const;
  void cancel(const OrderedJson& parameters);
  bool wait_for_turn(const std::atomic<bool>& cancel);

  const ServedFolder folder_;
  const ServerLimits limits_;
  const RunChild run_;
  std::mutex lock_;
  std::condition_variable turn_;
  unsigned running_ = 0;
  std::map<std::string, Cancel> jobs_;  // by the id of their call
};

}  // namespace sinew::cli
#endif

// SPDX-License-Identifier: MIT
// JSON-RPC 2.0 and the Model Context Protocol of 2025-06-18 (modelcontextprotocol.io/specification), tools and resources of it.
#include "serve/server.hpp"

#include <algorithm>
#include <chrono>

#include "sinew/sinew.h"
#include "sinew_formats/base64.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

constexpr int kParseError = -32700, kInvalidRequest = -32600, kNoMethod = -32601, kInvalidParameters = -32602,
              kNoResource = -32002;
constexpr const char* kVersions[] = {"2025-06-18", "2025-03-26", "2024-11-05"};  // the newest first
constexpr const char* kScheme = "sinew:///";

OrderedJson refusal(const OrderedJson& id, int code, const std::string& line) {
  return {{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", code}, {"message", line}}}};
}

// Media types (iana.org/assignments/media-types).
struct Kind {
  const char* mime;
  bool text;
};
Kind kind_of(const std::string& name) {
  const auto is = [&](const char* extension) { return has_extension(name, extension); };
  if (is(".glb") || is(".vrm")) return {"model/gltf-binary", false};
  if (is(".gltf")) return {"model/gltf+json", true};
  if (is(".obj")) return {"model/obj", true};
  if (is(".png")) return {"image/png", false};
  if (is(".jpg") || is(".jpeg")) return {"image/jpeg", false};
  if (is(".json") || is(".sarif")) return {"application/json", true};
  if (is(".html")) return {"text/html", true};
  if (is(".txt") || is(".bvh")) return {"text/plain", true};
  return {"application/octet-stream", false};
}

// Names in URIs: all but letters, digits and -._~/ as %XX (RFC 3986).
std::string uri_of(const std::string& name) {
  constexpr const char* kHex = "0123456789ABCDEF";
  std::string uri = kScheme;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') || (byte >= '0' && byte <= '9') ||
        std::string("-._~/").find(c) != std::string::npos)
      uri.push_back(c);
    else
      uri += {'%', kHex[byte >> 4], kHex[byte & 15]};
  }
  return uri;
}

std::string name_of(const std::string& uri) {
  const std::string scheme = kScheme;
  if (uri.rfind(scheme, 0) != 0)
    throw Error("'" + printable(uri) + "': expected a resource of this server, " + scheme + "NAME");
  const auto digit = [](char c) {
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
                                  : -1;
  };
  std::string name;
  for (size_t i = scheme.size(); i < uri.size(); ++i) {
    const int high = uri[i] == '%' && i + 2 < uri.size() ? digit(uri[i + 1]) : -1,
              low = high < 0 ? -1 : digit(uri[i + 2]);
    if (low < 0) {
      name.push_back(uri[i]);
      continue;
    }
    name.push_back(static_cast<char>(16 * high + low));
    i += 2;
  }
  return name;
}

std::string text_of(const OrderedJson& object, const char* name) {
  const auto found = object.is_object() ? object.find(name) : object.end();
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

OrderedJson text_content(const std::string& text) { return {{"type", "text"}, {"text", text}}; }

std::string why(const ChildResult& result, const ServerLimits& limits) {
  switch (result.end) {
    case ChildEnd::kTooLate:
      return "the job took longer than " + std::to_string(static_cast<int>(limits.seconds)) + " s (--timeout)";
    case ChildEnd::kCancelled:
      return "the job was cancelled";
    case ChildEnd::kTooLong:
      return "the job printed more than " + std::to_string(kMostOutput >> 20) + " MiB";
    case ChildEnd::kDone:
      break;
  }
  return result.errors.empty() ? "the job ended with status " + std::to_string(result.status) : result.errors;
}

}  // namespace

Server::Server(ServedFolder folder, ServerLimits limits, RunChild run)
    : folder_(std::move(folder)), limits_(limits), run_(std::move(run)) {}

bool Server::is_call(const std::string& message) {
  const OrderedJson json = OrderedJson::parse(message, nullptr, false);
  return text_of(json, "method") == "tools/call";
}

std::optional<OrderedJson> Server::answer(const std::string& message, const Notify& notify) {
  if (message.size() > limits_.message)
    return refusal(nullptr, kInvalidRequest,
                   "expected at most " + std::to_string(limits_.message) + " bytes per message");
  const OrderedJson request = OrderedJson::parse(message, nullptr, false);
  if (request.is_discarded()) return refusal(nullptr, kParseError, "expected a message in JSON");
  const std::string method = text_of(request, "method");
  const bool has_id = request.is_object() && request.contains("id");
  if (request.is_object() && method.empty() && (request.contains("result") || request.contains("error")))
    return std::nullopt;
  if (text_of(request, "jsonrpc") != "2.0" || method.empty() ||
      (has_id && !request["id"].is_string() && !request["id"].is_number_integer()))
    return refusal(nullptr, kInvalidRequest, "expected a request of JSON-RPC 2.0 with a method");
  const OrderedJson parameters = request.contains("params") ? request["params"] : OrderedJson::object();
  if (!has_id) {
    if (method == "notifications/cancelled") cancel(parameters);
    return std::nullopt;
  }
  const OrderedJson id = request["id"];
  try {
    return OrderedJson{{"jsonrpc", "2.0"}, {"id", id}, {"result", result_of(method, parameters, id.dump(), notify)}};
  } catch (const Refusal& refused) {
    return refusal(id, refused.code, refused.line);
  } catch (const Error& error) {
    return refusal(id, kInvalidParameters, printable(error.what()));
  }
}

OrderedJson Server::result_of(const std::string& method, const OrderedJson& parameters, const std::string& id,
                              const Notify& notify) {
  if (!parameters.is_object()) throw Refusal{kInvalidParameters, "expected an object as params"};
  if (method == "initialize") return initialize(parameters);
  if (method == "ping") return OrderedJson::object();
  if (method == "tools/list") return {{"tools", tools_json()}};
  if (method == "tools/call") return call(parameters, id, notify);
  if (method == "resources/list") return resources();
  if (method == "resources/read") return resource(parameters);
  if (method == "resources/templates/list") return {{"resourceTemplates", OrderedJson::array()}};
  throw Refusal{kNoMethod, "there is no method '" + printable(method) + "'"};
}

OrderedJson Server::initialize(const OrderedJson& parameters) const {
  const std::string asked = text_of(parameters, "protocolVersion");
  const bool known = std::find(std::begin(kVersions), std::end(kVersions), asked) != std::end(kVersions);
  return {
      {"protocolVersion", known ? asked : kVersions[0]},
      {"capabilities", {{"tools", OrderedJson::object()}, {"resources", OrderedJson::object()}}},
      {"serverInfo", {{"name", "sinew"}, {"title", "sinew"}, {"version", sinew_version()}}},
      {"instructions",
       "Skeletons, skin weights and motion for character meshes. Files are named relative to the served folder, as in "
       "resources/list. Warnings in an answer are guesses that may be wrong: show them, and a picture of a pose."}};
}

OrderedJson Server::call(const OrderedJson& parameters, const std::string& id, const Notify& notify) {
  const auto arguments = parameters.find("arguments");
  const OrderedJson none = OrderedJson::object();
  ToolRun job;
  try {
    job = tool_run(text_of(parameters, "name"), arguments == parameters.end() ? none : *arguments, folder_);
  } catch (const Error& error) {  // so that the caller can mend it
    return {{"content", OrderedJson::array({text_content(printable(error.what()))})}, {"isError", true}};
  }
  const Cancel cancelled = std::make_shared<std::atomic<bool>>(false);
  {
    const std::lock_guard<std::mutex> guard(lock_);
    jobs_[id] = cancelled;
  }
  const bool mine = wait_for_turn(*cancelled);
  OrderedJson result;
  try {
    if (mine) result = run(job, parameters, *cancelled, notify);
  } catch (const Error& error) {
    result = {{"content", OrderedJson::array({text_content(printable(error.what()))})}, {"isError", true}};
  }
  {
    const std::lock_guard<std::mutex> guard(lock_);
    if (mine) --running_;
    jobs_.erase(id);
  }
  turn_.notify_all();
  if (!mine) return {{"content", OrderedJson::array({text_content("the job was cancelled")})}, {"isError", true}};
  return result;
}

bool Server::wait_for_turn(const std::atomic<bool>& cancelled) {
  std::unique_lock<std::mutex> guard(lock_);
  turn_.wait(guard, [&] { return cancelled || running_ < limits_.jobs; });
  if (cancelled) return false;
  ++running_;
  return true;
}

OrderedJson Server::run(const ToolRun& job, const OrderedJson& parameters, const std::atomic<bool>& cancelled,
                        const Notify& notify) {
  const auto meta = parameters.find("_meta");
  const OrderedJson token = meta != parameters.end() && meta->is_object() && meta->contains("progressToken")
                                ? (*meta)["progressToken"]
                                : OrderedJson(nullptr);
  int lines = 0;
  const auto tell = [&](const std::string& line) {
    if (token.is_null()) return;
    notify({{"jsonrpc", "2.0"},
            {"method", "notifications/progress"},
            {"params", {{"progressToken", token}, {"progress", ++lines}, {"message", printable(line)}}}});
  };
  tell(job.words.front() + " began");
  const ChildResult result = run_(job.words, folder_.root().string(), limits_.seconds, cancelled, tell);
  OrderedJson content = OrderedJson::array();
  if (result.end != ChildEnd::kDone || result.status != 0) {
    content.push_back(text_content(why(result, limits_)));
    return {{"content", content}, {"isError", true}};
  }
  OrderedJson answer;
  if (job.json) answer = OrderedJson::parse(result.out, nullptr, false);
  if (!result.out.empty()) content.push_back(text_content(result.out));
  if (!result.errors.empty()) content.push_back(text_content(result.errors));
  for (const std::string& name : job.outputs) {
    const Kind kind = kind_of(name);
    content.push_back({{"type", "resource_link"}, {"uri", uri_of(name)}, {"name", name}, {"mimeType", kind.mime}});
    if (std::string(kind.mime) != "image/png") continue;
    std::string bytes = folder_.read(name);
    if (bytes.size() <= limits_.resource)
      content.push_back({{"type", "image"}, {"data", base64(bytes)}, {"mimeType", kind.mime}});
  }
  OrderedJson whole = {{"content", content}, {"isError", false}};
  if (answer.is_object()) whole["structuredContent"] = answer;
  return whole;
}

OrderedJson Server::resources() const {
  OrderedJson list = OrderedJson::array();
  for (const ServedFolder::File& file : folder_.files())
    list.push_back(
        {{"uri", uri_of(file.name)}, {"name", file.name}, {"mimeType", kind_of(file.name).mime}, {"size", file.bytes}});
  return {{"resources", list}};
}

OrderedJson Server::resource(const OrderedJson& parameters) const {
  const std::string uri = text_of(parameters, "uri");
  std::string bytes;
  try {
    bytes = folder_.read(name_of(uri));
  } catch (const Error& error) {
    throw Refusal{kNoResource, printable(error.what())};
  }
  if (bytes.size() > limits_.resource)
    throw Refusal{kNoResource, "'" + printable(uri) + "': " + std::to_string(bytes.size()) +
                                   " bytes, the server sends up to " + std::to_string(limits_.resource)};
  const Kind kind = kind_of(name_of(uri));
  OrderedJson one = {{"uri", uri}, {"mimeType", kind.mime}};
  if (kind.text)
    one["text"] = bytes;
  else
    one["blob"] = base64(bytes);
  return {{"contents", OrderedJson::array({one})}};
}

void Server::cancel(const OrderedJson& parameters) {
  const auto id = parameters.is_object() ? parameters.find("requestId") : parameters.end();
  if (id == parameters.end()) return;
  {
    const std::lock_guard<std::mutex> guard(lock_);
    const auto job = jobs_.find(id->dump());
    if (job != jobs_.end()) *job->second = true;
  }
  turn_.notify_all();
}

}  // namespace sinew::cli

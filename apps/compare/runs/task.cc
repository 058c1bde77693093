// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/runs/task.h"

#include <nlohmann/json.hpp>

namespace latchwork::compare {

using Json = nlohmann::ordered_json;

std::string ToText(const Task& task) {
  const Json json = {{"scenario", task.run.key.scenario},  {"agent", task.run.key.contender},
                     {"seed", task.run.key.seed},          {"arguments", task.run.arguments},
                     {"wall_s", task.limits.wall_seconds}, {"memory_mb", task.limits.memory_mb}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<Task> TaskFromText(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  try {
    Task task;
    task.run.key = {json.at("scenario"), json.at("agent"), json.at("seed")};
    json.at("arguments").get_to(task.run.arguments);
    json.at("wall_s").get_to(task.limits.wall_seconds);
    json.at("memory_mb").get_to(task.limits.memory_mb);
    return task;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace latchwork::compare

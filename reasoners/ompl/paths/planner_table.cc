// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/ompl/paths/planner_table.h"

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/planners/est/BiEST.h>
#include <ompl/geometric/planners/est/EST.h>
#include <ompl/geometric/planners/fmt/BFMT.h>
#include <ompl/geometric/planners/fmt/FMT.h>
#include <ompl/geometric/planners/informedtrees/ABITstar.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/kpiece/BKPIECE1.h>
#include <ompl/geometric/planners/kpiece/KPIECE1.h>
#include <ompl/geometric/planners/kpiece/LBKPIECE1.h>
#include <ompl/geometric/planners/pdst/PDST.h>
#include <ompl/geometric/planners/prm/LazyPRM.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/LazyRRT.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTsharp.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/geometric/planners/rrt/TRRT.h>
#include <ompl/geometric/planners/sbl/SBL.h>
#include <ompl/geometric/planners/stride/STRIDE.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <memory>
#include <optional>
#include <sstream>

#include "reasoners/ompl/paths/counted_prm.h"

namespace latchwork::planning {
namespace {

namespace ob = ::ompl::base;
namespace og = ::ompl::geometric;

using Factory = ob::PlannerPtr (*)(const ob::SpaceInformationPtr&);

template <typename Planner>
ob::PlannerPtr Make(const ob::SpaceInformationPtr& space) {
  return std::make_shared<Planner>(space);
}

struct Entry {
  std::string_view name;
  Factory make;
};

constexpr std::array<Entry, 22> kPlanners = {{
    {"RRTConnect", Make<og::RRTConnect>},
    {"RRT", Make<og::RRT>},
    {"RRTstar", Make<og::RRTstar>},
    {"RRTsharp", Make<og::RRTsharp>},
    {"InformedRRTstar", Make<og::InformedRRTstar>},
    {"LazyRRT", Make<og::LazyRRT>},
    {"TRRT", Make<og::TRRT>},
    {"BITstar", Make<og::BITstar>},
    {"ABITstar", Make<og::ABITstar>},
    {"FMT", Make<og::FMT>},
    {"BFMT", Make<og::BFMT>},
    {"PRM",
     [](const ob::SpaceInformationPtr& space) -> ob::PlannerPtr {
       return std::make_shared<CountedPrm>(space, false);
     }},
    {"PRMstar",
     [](const ob::SpaceInformationPtr& space) -> ob::PlannerPtr {
       return std::make_shared<CountedPrm>(space, true);
     }},
    {"LazyPRM", Make<og::LazyPRM>},
    {"KPIECE1", Make<og::KPIECE1>},
    {"BKPIECE1", Make<og::BKPIECE1>},
    {"LBKPIECE1", Make<og::LBKPIECE1>},
    {"EST", Make<og::EST>},
    {"BiEST", Make<og::BiEST>},
    {"SBL", Make<og::SBL>},
    {"STRIDE", Make<og::STRIDE>},
    {"PDST", Make<og::PDST>},
}};

const Entry& EntryOf(std::string_view name) {
  return *std::find_if(kPlanners.begin(), kPlanners.end(),
                       [&](const Entry& entry) { return entry.name == name; });
}

std::optional<double> Number(std::string_view text) {
  double value = 0.0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// OMPL suggests "low:high" or "low:step:high" for numbers and "0,1" for the others.
bool IsWithin(const std::string& value, const std::string& suggestion) {
  const std::size_t first = suggestion.find(':');
  if (first == std::string::npos) {
    return suggestion.empty() ||
           ("," + suggestion + ",").find("," + value + ",") != std::string::npos;
  }
  const auto bound = [](std::string text) {
    if (text.ends_with('.')) text.pop_back();
    return Number(text);
  };
  const auto number = Number(value);
  const auto low = bound(suggestion.substr(0, first));
  const auto high = bound(suggestion.substr(suggestion.rfind(':') + 1));
  return number && (!low || *number >= *low) && (!high || *number <= *high);
}

/// A planner in a plane where nothing is in the way, only to be asked what it knows.
ob::PlannerPtr Specimen(std::string_view name) {
  const auto plane = std::make_shared<ob::RealVectorStateSpace>(2);
  plane->setBounds(0.0, 1.0);
  return EntryOf(name).make(std::make_shared<ob::SpaceInformation>(plane));
}

std::string Known(const ob::ParamSet& known) {
  std::string list;
  for (const auto& [name, parameter] : known.getParams()) {
    list += (list.empty() ? "" : ", ") + name;
  }
  return list.empty() ? "it has none" : "it has " + list;
}

std::string Mistake(const ob::ParamSet& known, std::string_view planner, const std::string& name,
                    const std::string& value) {
  if (name.empty() || value.empty()) return "an option is written name=value";
  if (!known.hasParam(name)) {
    return std::string(planner) + " has no option '" + name + "'";
  }
  const std::string& range = known.getParam(name)->getRangeSuggestion();
  if (!IsWithin(value, range) || !known.getParam(name)->setValue(value)) {
    return "'" + value + "' is no value for the option '" + name + "' of " + std::string(planner) +
           (range.empty() ? "" : ": " + range);
  }
  return {};
}

}  // namespace

std::vector<std::string> PlannerNames() {
  std::vector<std::string> names;
  for (const Entry& entry : kPlanners) names.emplace_back(entry.name);
  return names;
}

ob::PlannerPtr MakePlanner(std::string_view name, const ob::SpaceInformationPtr& space) {
  return EntryOf(name).make(space);
}

PlannerOptions ReadPlannerOptions(std::string_view text, std::string_view planner,
                                  const logic::SourcePlace& place,
                                  logic::Diagnostics& diagnostics) {
  const ob::PlannerPtr specimen = Specimen(planner);
  PlannerOptions options;
  std::istringstream words{std::string(text)};
  for (std::string word; words >> word;) {
    const std::size_t equals = std::min(word.find('='), word.size());
    const std::string name = word.substr(0, equals);
    const std::string value = word.substr(std::min(equals + 1, word.size()));
    const std::string mistake = Mistake(specimen->params(), planner, name, value);
    if (mistake.empty()) {
      options.emplace_back(name, value);
    } else {
      diagnostics.push_back({place, mistake, Known(specimen->params()), {}});
    }
  }
  return options;
}

}  // namespace latchwork::planning

// SPDX-License-Identifier: BSD-3-Clause
#include "tests/core/config/agent_fixture.h"

#include <map>
#include <stdexcept>
#include <utility>

namespace latchwork::config {
namespace {

using sdk::ArgumentType;

sdk::PredicateSpec Sonar(ArgumentType distance = ArgumentType::kReal, std::string unit = "m") {
  return {
      "sonar_reading", {{"N", ArgumentType::kInteger, ""}, {"D", distance, std::move(unit)}}, ""};
}
const sdk::PredicateSpec kMove = {
    "move_cmd", {{"X", ArgumentType::kReal, "m"}, {"Y", ArgumentType::kReal, "m"}}, ""};
const sdk::PredicateSpec kObject = {"object", {{"O", ArgumentType::kSymbol, ""}}, ""};
const sdk::PredicateSpec kTurn = {"turn", {{"A", ArgumentType::kReal, "rad"}}, ""};
const sdk::PredicateSpec kHalt = {"halt", {}, ""};
const sdk::PredicateSpec kPose = {"pose", {{"X", ArgumentType::kReal, "m"}}, ""};

PluginFacts Hall() {
  PluginFacts facts;
  facts.contract.outputs = {
      {"sonar", {Sonar()}, ""},
      {"pose", {kPose}, ""},
      {"feet", {Sonar(ArgumentType::kReal, "ft")}, ""},
      {"echo", {{"sonar_reading", {{"N", ArgumentType::kInteger, ""}}, ""}}, ""},
      {"names", {Sonar(ArgumentType::kSymbol, "")}, ""}};
  facts.contract.inputs = {{"drive", {kTurn, kHalt}, ""}};
  facts.parameters = {{.name = "people",
                       .type = sdk::ParameterType::kInteger,
                       .default_value = "4",
                       .minimum = 0,
                       .maximum = 50}};
  facts.events = {{"out_of_order", {{"E", ArgumentType::kSymbol, ""}}, ""}};
  return facts;
}

PluginFacts Avoid() {
  PluginFacts facts;
  facts.contract.inputs = {
      {"sonar", {Sonar()}, ""},
      {.name = "objects", .predicates = {kObject}, .help = "", .optional = true}};
  facts.contract.outputs = {
      {.name = "motion", .predicates = {kTurn, kHalt}, .help = "", .uninhibitable = true},
      {"chatter", {kObject}, ""}};
  facts.parameters = {{.name = "gain", .default_value = "1", .minimum = 0}};
  facts.languages = {"tptp", "icarus"};
  return facts;
}

PluginFacts Seek() {
  PluginFacts facts;
  facts.contract.inputs = {{"pose", {kPose}, ""}};
  facts.contract.outputs = {{"push", {kObject}, ""}};
  facts.languages = {"tptp"};
  return facts;
}

PluginFacts Reasoner(std::string language) {
  PluginFacts facts;
  facts.languages = {std::move(language)};
  facts.parameters = {
      {.name = "cache", .type = sdk::ParameterType::kBoolean, .default_value = "true"}};
  return facts;
}

using Shelf = std::map<std::string, PluginFacts, std::less<>>;

Shelf ShelfOf(sdk::PluginKind kind) {
  if (kind == sdk::PluginKind::kWorld) return {{"hall", Hall()}};
  if (kind == sdk::PluginKind::kLayer) return {{"avoid", Avoid()}, {"seek", Seek()}};
  return {{"icarus", Reasoner("icarus")}, {"pttp", Reasoner("tptp")}};
}

}  // namespace

Catalog FakeCatalog() {
  Catalog catalog;
  catalog.names = [](sdk::PluginKind kind) {
    std::vector<std::string> names;
    for (const auto& [name, facts] : ShelfOf(kind)) names.push_back(name);
    return names;
  };
  catalog.find = [](sdk::PluginKind kind, std::string_view name,
                    std::string& error) -> std::optional<PluginFacts> {
    const Shelf shelf = ShelfOf(kind);
    if (const auto found = shelf.find(name); found != shelf.end()) return found->second;
    if (name == "torn") error = "file too short";
    return std::nullopt;
  };
  return catalog;
}

void AgentTest::Write(const std::string& name, std::string_view text) const {
  folder_.Write(name, text);
}

AgentFile AgentTest::Read(std::string_view text, const std::vector<Override>& overrides) {
  Write("agent.xml", text);
  return ReadAgentFile(folder_.path() / "agent.xml", FakeCatalog(), overrides, symbols_);
}

std::vector<std::string> AgentTest::Errors(std::string_view text,
                                           const std::vector<Override>& overrides) {
  std::vector<std::string> lines;
  for (const logic::Diagnostic& diagnostic : Read(text, overrides).diagnostics) {
    const auto& place = diagnostic.place;
    const std::string file = std::filesystem::path(place.file).filename().string();
    std::string line = file == "agent.xml" ? "" : file + ":";
    line += std::to_string(place.line) + ":" + std::to_string(place.column) + ": ";
    line += diagnostic.message;
    if (!diagnostic.hint.empty()) line += " [" + diagnostic.hint + "]";
    for (std::size_t at = 0;
         (at = line.find(folder_.path().string() + "/")) != std::string::npos;) {
      line.erase(at, folder_.path().string().size() + 1);
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

std::string GoodAgent() {
  return R"xml(<agent format="1" name="test" tick="100ms" duration="60s">
<world plugin="hall"><param name="people" value="7"/></world>
<layer name="avoid" plugin="avoid" period="100ms">
<reasoner plugin="pttp" inferences="1000" depth="24"/>
</layer>
<layer name="seek" plugin="seek" period="200ms" phase="100ms" latency="100ms">
<reasoner plugin="pttp"/>
</layer>
<wire from="world.sonar" to="avoid.sonar" stale-after="300ms"/>
<wire from="seek.push" to="avoid.objects" stale-after="600ms"/>
<wire from="avoid.motion" to="world.drive"/>
<wire from="world.pose" to="seek.pose"/>
<event at="30s" fact="out_of_order(e2)"/>
</agent>
)xml";
}

std::string GoodAgentWith(std::string_view piece, std::string_view replacement) {
  std::string text = GoodAgent();
  const std::size_t at = text.find(piece);
  if (at == std::string::npos) throw std::invalid_argument(std::string(piece));
  return text.replace(at, piece.size(), replacement);
}

}  // namespace latchwork::config

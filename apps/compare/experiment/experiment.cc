// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/experiment/experiment.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <system_error>
#include <utility>

#include "core/config/document.h"
#include "latchwork/config/xml.h"

namespace latchwork::compare {
namespace {

constexpr std::string_view kSchema = R"xsd(<?xml version="1.0" encoding="UTF-8"?>
<xs:schema xmlns:xs="http://www.w3.org/2001/XMLSchema">
  <xs:element name="experiment" type="Experiment"/>
  <xs:complexType name="Experiment">
    <xs:choice minOccurs="0" maxOccurs="unbounded">
      <xs:element name="scenario" type="Scenario"/>
      <xs:element name="agent" type="Agent"/>
    </xs:choice>
    <xs:attribute name="format" type="Format" use="required"/>
    <xs:attribute name="name" type="Name" use="required"/>
    <xs:attribute name="seeds" type="Seeds" use="required"/>
    <xs:attribute name="level" type="Level"/>
    <xs:attribute name="wall" type="Seconds"/>
    <xs:attribute name="memory" type="Megabytes"/>
  </xs:complexType>
  <xs:complexType name="Scenario">
    <xs:attribute name="name" type="Name" use="required"/>
    <xs:attribute name="file" type="Path" use="required"/>
  </xs:complexType>
  <xs:complexType name="Agent">
    <xs:choice minOccurs="0" maxOccurs="unbounded">
      <xs:element name="set" type="Set"/>
    </xs:choice>
    <xs:attribute name="name" type="Name" use="required"/>
    <xs:attribute name="fragment" type="Path"/>
    <xs:attribute name="seed_offset" type="Offset"/>
  </xs:complexType>
  <xs:complexType name="Set">
    <xs:attribute name="name" type="Setting" use="required"/>
    <xs:attribute name="value" type="xs:string" use="required"/>
  </xs:complexType>
  <xs:simpleType name="Format">
    <xs:annotation><xs:documentation>the number of the format, 1</xs:documentation></xs:annotation>
    <xs:restriction base="xs:string"><xs:pattern value="1"/></xs:restriction>
  </xs:simpleType>
  <xs:simpleType name="Name">
    <xs:annotation><xs:documentation>a name (a letter, then up to 63 letters, digits, '_' or '-')</xs:documentation></xs:annotation>
    <xs:restriction base="xs:string"><xs:pattern value="[A-Za-z][A-Za-z0-9_\-]{0,63}"/></xs:restriction>
  </xs:simpleType>
  <xs:simpleType name="Seeds">
    <xs:annotation><xs:documentation>seeds, the first and the last, as in 1-30</xs:documentation></xs:annotation>
    <xs:restriction base="xs:string"><xs:pattern value="[0-9]{1,9}-[0-9]{1,9}"/></xs:restriction>
  </xs:simpleType>
  <xs:simpleType name="Offset">
    <xs:annotation><xs:documentation>a number that is added to the seeds, as in 1000</xs:documentation></xs:annotation>
    <xs:restriction base="xs:string"><xs:pattern value="[0-9]{1,9}"/></xs:restriction>
  </xs:simpleType>
  <xs:simpleType name="Level">
    <xs:annotation><xs:documentation>a level of significance between 0 and 1, as in 0.05</xs:documentation></xs:annotation>
    <xs:restriction base="xs:string"><xs:pattern value="0\.[0-9]{0,5}[1-9][0-9]{0,5}"/></xs:restriction>
  </xs:simpleType>
  <xs:simpleType name="Seconds">
    <xs:annotation><xs:documentation>seconds and their unit, as in 60s</xs:documentation></xs:annotation>
    <xs:restriction base="xs:string"><xs:pattern value="[1-9][0-9]{0,5}s"/></xs:restriction>
  </xs:simpleType>
  <xs:simpleType name="Megabytes">
    <xs:annotation><xs:documentation>megabytes and their unit, as in 4096MB</xs:documentation></xs:annotation>
    <xs:restriction base="xs:string"><xs:pattern value="[1-9][0-9]{0,6}MB"/></xs:restriction>
  </xs:simpleType>
  <xs:simpleType name="Path">
    <xs:annotation><xs:documentation>the path of a file</xs:documentation></xs:annotation>
    <xs:restriction base="xs:string"><xs:pattern value=".{1,4096}"/></xs:restriction>
  </xs:simpleType>
  <xs:simpleType name="Setting">
    <xs:annotation><xs:documentation>a part or its reasoner, a dot and a parameter, as in avoid.gain or avoid.reasoner.depth</xs:documentation></xs:annotation>
    <xs:restriction base="xs:string"><xs:pattern value="[A-Za-z][A-Za-z0-9_\-]*(\.reasoner)?\.[A-Za-z0-9_\-]+"/></xs:restriction>
  </xs:simpleType>
</xs:schema>
)xsd";

constexpr std::uint64_t kMostSeeds = 100'000;
constexpr std::uint64_t kMostRuns = 1'000'000;

/// A number that the schema has checked; what stands behind it is left out.
std::uint64_t NumberOf(std::string_view text) {
  std::uint64_t number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

class Reader {
 public:
  /// What the schema says against the file is told and not said again.
  Reader(const config::Element& root, const std::filesystem::path& file,
         logic::Diagnostics diagnostics)
      : root_(root), folder_(file.parent_path()), diagnostics_(std::move(diagnostics)) {}

  ExperimentFile Run() {
    Experiment& experiment = experiment_;
    if (const auto* name = root_.Find("name")) experiment.name = name->value;
    if (const auto* seeds = root_.Find("seeds")) ReadSeeds(*seeds);
    experiment.limits_place = root_.place;
    if (const auto* level = root_.Find("level")) {
      const std::string& text = level->value;
      std::from_chars(text.data(), text.data() + text.size(), experiment.level);
    }
    if (const auto* wall = root_.Find("wall")) {
      experiment.limits.wall_seconds = static_cast<double>(NumberOf(wall->value));
    }
    if (const auto* memory = root_.Find("memory")) {
      experiment.limits.memory_mb = NumberOf(memory->value);
      experiment.limits_place = memory->place;
    }
    for (const config::Element& child : root_.children) ReadChild(child);
    CountParts();
    ExperimentFile result;
    if (diagnostics_.empty()) result.experiment = std::move(experiment_);
    result.diagnostics = std::move(diagnostics_);
    return result;
  }

 private:
  /// An element whose name is misspelt may be what is missing.
  void CountParts() {
    const auto is_known = [](const config::Element& child) {
      return child.name == "scenario" || child.name == "agent";
    };
    if (!std::ranges::all_of(root_.children, is_known)) return;
    if (scenarios_ == 0) {
      Say(root_.place, "there is no <scenario>", "add one: <scenario name=\"…\" file=\"…\"/>");
    }
    if (contenders_ < 2) {
      Say(root_.place, "a comparison needs two <agent> or more",
          "add another: <agent name=\"…\" fragment=\"…\"/>");
    }
    const std::uint64_t seeds = experiment_.last_seed - experiment_.first_seed + 1;
    if (diagnostics_.empty() && scenarios_ * contenders_ > kMostRuns / seeds) {
      Say(root_.place, fmt::format("{} scenarios, {} agents and {} seeds make more than {} runs",
                                   scenarios_, contenders_, seeds, kMostRuns));
    }
  }

  bool IsTold(const logic::SourcePlace& place) const {
    return place.line > 0 && std::ranges::any_of(diagnostics_, [&](const auto& each) {
             return each.place.line == place.line && each.place.column == place.column;
           });
  }

  void Say(const logic::SourcePlace& place, std::string message, std::string hint = "") {
    diagnostics_.push_back({place, std::move(message), std::move(hint), ""});
  }

  void ReadSeeds(const config::Attribute& seeds) {
    if (IsTold(seeds.place)) return;
    const std::size_t dash = seeds.value.find('-');
    experiment_.first_seed = NumberOf(seeds.value);
    experiment_.last_seed = NumberOf(std::string_view{seeds.value}.substr(dash + 1));
    if (experiment_.last_seed < experiment_.first_seed) {
      Say(seeds.place, "the last seed comes before the first",
          fmt::format("write {}-{}", experiment_.last_seed, experiment_.first_seed));
    } else if (experiment_.last_seed - experiment_.first_seed >= kMostSeeds) {
      Say(seeds.place, fmt::format("these are more than {} seeds", kMostSeeds));
    }
  }

  void TellTwins(const config::Element& child, std::vector<std::string>& known) {
    const auto* name = child.Find("name");
    if (name == nullptr || IsTold(name->place)) return;
    if (std::ranges::find(known, name->value) != known.end()) {
      Say(name->place, fmt::format("there are two <{}> called '{}'", child.name, name->value));
    }
    known.push_back(name->value);
  }

  void ReadChild(const config::Element& child) {
    if (child.name == "scenario") {
      ReadScenario(child);
    } else if (child.name == "agent") {
      ReadContender(child);
    }
  }

  void ReadScenario(const config::Element& child) {
    ++scenarios_;
    TellTwins(child, scenario_names_);
    const auto* file = child.Find("file");
    std::filesystem::path path = file == nullptr ? "" : PathOf(*file);
    const auto* name = child.Find("name");
    if (file == nullptr || name == nullptr) return;
    experiment_.scenarios.push_back({name->value, std::move(path), file->place});
  }

  void ReadContender(const config::Element& child) {
    ++contenders_;
    TellTwins(child, contender_names_);
    Contender contender;
    contender.place = child.place;
    if (const auto* name = child.Find("name")) contender.name = name->value;
    if (const auto* offset = child.Find("seed_offset")) {
      contender.seed_offset = NumberOf(offset->value);
    }
    if (const auto* fragment = child.Find("fragment")) contender.fragment = PathOf(*fragment);
    for (const config::Element& set : child.children) {
      const auto* name = set.Find("name");
      const auto* value = set.Find("value");
      if (name == nullptr || value == nullptr) continue;
      contender.settings.push_back(name->value + "=" + value->value);
      contender.setting_places.push_back(name->place);
    }
    experiment_.contenders.push_back(std::move(contender));
  }

  std::filesystem::path PathOf(const config::Attribute& attribute) {
    const std::filesystem::path path = folder_ / attribute.value;
    std::error_code error;
    if (!IsTold(attribute.place) && !std::filesystem::is_regular_file(path, error)) {
      Say(attribute.place, fmt::format("there is no file '{}'", path.string()),
          "paths are relative to the experiment's file");
    }
    return path.lexically_normal();
  }

  const config::Element& root_;
  std::filesystem::path folder_;
  logic::Diagnostics diagnostics_;
  Experiment experiment_;
  std::vector<std::string> scenario_names_;
  std::vector<std::string> contender_names_;
  std::uint64_t scenarios_ = 0;
  std::uint64_t contenders_ = 0;
};

ExperimentFile Finish(config::XmlFile xml, const std::filesystem::path& file) {
  ExperimentFile result;
  if (xml.complete && xml.root.name == "experiment") {
    result = Reader(xml.root, file, std::move(xml.diagnostics)).Run();
  } else {
    result.diagnostics = std::move(xml.diagnostics);
  }
  config::Arrange({{file.string(), xml.bytes}}, result.diagnostics);
  if (result.experiment) result.experiment->text = std::move(xml.bytes);
  return result;
}

}  // namespace

ExperimentFile ReadExperiment(const std::filesystem::path& file) {
  return Finish(config::ReadXml(file, kSchema), file);
}

ExperimentFile ReadExperimentText(std::string_view text, const std::filesystem::path& name) {
  return Finish(config::ReadXmlText(text, name.string(), kSchema), name);
}

}  // namespace latchwork::compare

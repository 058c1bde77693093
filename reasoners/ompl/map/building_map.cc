// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/ompl/map/building_map.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "latchwork/logic/tptp.h"

namespace latchwork::planning {
namespace {

using logic::Term;

bool IsAbout(const logic::Atom& atom, std::string_view name, std::size_t arity) {
  return atom.predicate().name() == name && atom.arity() == arity;
}

bool IsInteger(const Term& term) { return term.kind() == Term::Kind::kInteger; }
bool IsName(const Term& term) { return term.kind() == Term::Kind::kConstant; }

class Reader {
 public:
  explicit Reader(std::filesystem::path folder) : folder_(std::move(folder)) {}

  void Read(const logic::AnnotatedFormula& formula) {
    if (formula.formula.kind() != logic::Formula::Kind::kAtom) return;
    place_ = formula.place;
    const logic::Atom& atom = formula.formula.atom();
    if (IsAbout(atom, "floor", 3)) AddFloor(atom);
    if (IsAbout(atom, "landmark", 4)) AddLandmark(atom);
  }

  ReadBuildingMap Take() { return std::move(result_); }

 private:
  void Fail(std::string message) {
    result_.diagnostics.push_back({place_, std::move(message), {}, {}});
  }

  void AddFloor(const logic::Atom& atom) {
    const auto terms = atom.arguments();
    if (!IsInteger(terms[0]) || !IsName(terms[1]) || !terms[2].is_number()) {
      return Fail("a floor has a whole number, the name of a picture and metres per pixel");
    }
    const double resolution = terms[2].number();
    if (!(resolution >= 0.005 && resolution <= 1.0)) {
      return Fail("a pixel has between 0.005 and 1 m");
    }
    ReadGrid read = ReadPng(folder_ / terms[1].symbol().name(), resolution);
    if (!read.grid) return Fail(std::move(read.error));
    const bool is_new =
        result_.map.floors.emplace(terms[0].integer(), DistanceMap(*read.grid)).second;
    if (!is_new) Fail("floor " + logic::ToString(terms[0]) + " twice");
  }

  void AddLandmark(const logic::Atom& atom) {
    const auto terms = atom.arguments();
    if (!IsName(terms[0]) || !IsInteger(terms[1]) || !terms[2].is_number() ||
        !terms[3].is_number()) {
      return Fail("a landmark has a name, a whole number as its floor, and two coordinates");
    }
    const Place place{terms[1].integer(), {terms[2].number(), terms[3].number()}};
    result_.map.landmarks.insert_or_assign(terms[0].symbol(), place);
  }

  std::filesystem::path folder_;
  ReadBuildingMap result_;
  logic::SourcePlace place_;
};

}  // namespace

ReadBuildingMap ReadBuilding(const std::filesystem::path& file, double resolution,
                             const logic::SourcePlace& place, logic::SymbolTable& symbols) {
  ReadBuildingMap result;
  if (file.extension() == ".png") {
    ReadGrid read = ReadPng(file, resolution);
    if (read.grid) {
      result.map.floors.emplace(1, DistanceMap(*read.grid));
    } else {
      result.diagnostics.push_back({place, std::move(read.error), {}, {}});
    }
    return result;
  }
  if (file.extension() != ".p") {
    result.diagnostics.push_back({place,
                                  file.string() + ": not a map for planners",
                                  "give a building (.p) or the picture of one floor (.png)",
                                  {}});
    return result;
  }
  logic::TptpFile tptp = logic::ReadTptpFile(file, symbols);
  if (!tptp.diagnostics.empty()) {
    result.diagnostics = std::move(tptp.diagnostics);
    return result;
  }
  Reader reader(file.parent_path());
  for (const logic::AnnotatedFormula& formula : tptp.formulas) reader.Read(formula);
  result = reader.Take();
  if (result.diagnostics.empty() && result.map.floors.empty()) {
    result.diagnostics.push_back({{file.string(), 0, 0}, "the building has no floor", {}, {}});
  }
  return result;
}

}  // namespace latchwork::planning

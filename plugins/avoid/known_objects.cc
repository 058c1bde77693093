// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/avoid/known_objects.h"

#include <cmath>

namespace latchwork::avoid {
namespace {

using logic::Term;

class ObjectSink final : public sdk::AnswerSink {
 public:
  ObjectSink(logic::Symbol sensed, std::vector<RelativeObject>& objects)
      : sensed_(sensed), objects_(&objects) {}

  void Answer(std::span<const Term> terms) override {
    if (!terms[1].is_number() || !terms[2].is_number()) return;
    const double distance = terms[1].number();
    const double direction = terms[2].number();
    if (!std::isfinite(distance) || !std::isfinite(direction) || distance < 0.0) return;
    const bool is_sensed = terms[0].kind() == Term::Kind::kCompound && terms[0].symbol() == sensed_;
    objects_->push_back({distance, direction, !is_sensed});
  }

 private:
  logic::Symbol sensed_;
  std::vector<RelativeObject>* objects_;
};

class RadiusSink final : public sdk::AnswerSink {
 public:
  void Answer(std::span<const Term> terms) override {
    if (terms[0].is_number()) radius = terms[0].number();
  }

  double radius = -1.0;
};

}  // namespace

KnownObjects::KnownObjects(logic::SymbolTable& symbols) : sensed_(symbols.Intern("sonar_obj")) {
  const Term object = Term::Var(0);
  const Term distance = Term::Var(1);
  const Term direction = Term::Var(2);
  objects_query_ = {{true, {symbols.Intern("object"), {object}}},
                    {true, {symbols.Intern("distance"), {object, distance}}},
                    {true, {symbols.Intern("direction"), {object, direction}}}};
  radius_query_ = {{true, {symbols.Intern("robot_radius"), {Term::Var(0)}}}};
}

std::span<const RelativeObject> KnownObjects::Collect(sdk::AttachmentContext& context) {
  objects_.clear();
  ObjectSink sink(sensed_, objects_);
  context.ForEachProvable(objects_query_, 3, sink);
  return objects_;
}

double KnownObjects::RobotRadius(sdk::AttachmentContext& context) {
  RadiusSink sink;
  context.ForEachProvable(radius_query_, 1, sink);
  return sink.radius;
}

}  // namespace latchwork::avoid

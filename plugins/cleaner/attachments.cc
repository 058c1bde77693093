// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/cleaner/attachments.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "plugins/cleaner/remembered_floor.h"
#include "plugins/cleaner/row_after.h"
#include "plugins/cleaner/ways.h"

namespace latchwork::cleaner {

namespace {

using logic::Term;
using sdk::ArgumentType;
using sdk::Attachment;
using Mode = Attachment::Mode;

Attachment::Argument Given(std::string name, ArgumentType type, std::string unit = {}) {
  return {{std::move(name), type, std::move(unit)}, Mode::kIn};
}
Attachment::Argument Answered(std::string name, ArgumentType type, std::string unit = {}) {
  return {{std::move(name), type, std::move(unit)}, Mode::kOut};
}

class TileAt final : public Attachment {
 public:
  const Signature& signature() const override {
    static const Signature signature{
        "tile_at",
        {Given("x", ArgumentType::kReal, "m"), Given("y", ArgumentType::kReal, "m"),
         Given("size", ArgumentType::kReal, "m"), Answered("i", ArgumentType::kInteger),
         Answered("j", ArgumentType::kInteger)},
        "the tile of a place"};
    return signature;
  }

  void Call(std::span<const Term> inputs, sdk::AttachmentContext& /*context*/,
            sdk::AnswerSink& outputs) override {
    const double i = std::floor(inputs[0].number() / inputs[2].number());
    const double j = std::floor(inputs[1].number() / inputs[2].number());
    if (!(std::abs(i) < kMostTiles && std::abs(j) < kMostTiles)) return;
    const std::array<Term, 2> answer{Term::Integer(static_cast<std::int64_t>(i)),
                                     Term::Integer(static_cast<std::int64_t>(j))};
    outputs.Answer(answer);
  }
};

class Bearing final : public Attachment {
 public:
  const Signature& signature() const override {
    static const Signature signature{
        "bearing",
        {Given("x", ArgumentType::kReal, "m"), Given("y", ArgumentType::kReal, "m"),
         Given("heading", ArgumentType::kReal, "rad"), Given("i", ArgumentType::kInteger),
         Given("j", ArgumentType::kInteger), Given("size", ArgumentType::kReal, "m"),
         Answered("distance", ArgumentType::kReal, "m"),
         Answered("bearing", ArgumentType::kReal, "rad")},
        "the middle of a tile as the robot sees it; left > 0"};
    return signature;
  }

  void Call(std::span<const Term> inputs, sdk::AttachmentContext& /*context*/,
            sdk::AnswerSink& outputs) override {
    const double size = inputs[5].number();
    const double dx = (inputs[3].number() + 0.5) * size - inputs[0].number();
    const double dy = (inputs[4].number() + 0.5) * size - inputs[1].number();
    const double bearing =
        std::remainder(std::atan2(dy, dx) - inputs[2].number(), 2.0 * std::numbers::pi);
    const std::array<Term, 2> answer{Term::Real(std::hypot(dx, dy)), Term::Real(bearing)};
    outputs.Answer(answer);
  }
};

class NearestDirt final : public Attachment {
 public:
  explicit NearestDirt(logic::SymbolTable& symbols) : floor_(symbols) {}

  const Signature& signature() const override {
    static const Signature signature{
        "nearest_dirt",
        {Given("i", ArgumentType::kInteger), Given("j", ArgumentType::kInteger),
         Answered("ti", ArgumentType::kInteger), Answered("tj", ArgumentType::kInteger)},
        "the nearest tile to stand on, not tried yet, with dirt around it"};
    return signature;
  }

  void Call(std::span<const Term> inputs, sdk::AttachmentContext& context,
            sdk::AnswerSink& outputs) override {
    const auto from = TileOf(inputs[0], inputs[1]);
    if (!from) return;
    floor_.Recall(context);
    const auto step = ways_.ToDirt(floor_, *from);
    if (!step) return;
    const std::array<Term, 2> answer{Term::Integer(step->next.i), Term::Integer(step->next.j)};
    outputs.Answer(answer);
  }

 private:
  RememberedFloor floor_;
  Ways ways_;
};

class Way final : public Attachment {
 public:
  explicit Way(logic::SymbolTable& symbols) : floor_(symbols) {}

  const Signature& signature() const override {
    static const Signature signature{
        "way",
        {Given("i", ArgumentType::kInteger), Given("j", ArgumentType::kInteger),
         Given("ti", ArgumentType::kInteger), Given("tj", ArgumentType::kInteger),
         Answered("ni", ArgumentType::kInteger), Answered("nj", ArgumentType::kInteger),
         Answered("length", ArgumentType::kReal, "tiles")},
        "the first tile at which the shortest way over remembered floor bends, or its end, and how "
        "long it is"};
    return signature;
  }

  void Call(std::span<const Term> inputs, sdk::AttachmentContext& context,
            sdk::AnswerSink& outputs) override {
    const auto from = TileOf(inputs[0], inputs[1]);
    const auto to = TileOf(inputs[2], inputs[3]);
    if (!from || !to) return;
    floor_.Recall(context);
    const auto step = ways_.To(floor_, *from, *to);
    if (!step) return;
    const std::array<Term, 3> answer{Term::Integer(step->next.i), Term::Integer(step->next.j),
                                     Term::Real(step->length)};
    outputs.Answer(answer);
  }

 private:
  RememberedFloor floor_;
  Ways ways_;
};

}  // namespace

std::vector<std::shared_ptr<Attachment>> MakeAttachments(logic::SymbolTable& symbols) {
  return {std::make_shared<TileAt>(), std::make_shared<Bearing>(),
          std::make_shared<RowAfter>(symbols), std::make_shared<NearestDirt>(symbols),
          std::make_shared<Way>(symbols)};
}

}  // namespace latchwork::cleaner

// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/machine/fact_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "latchwork/sdk/random.h"

namespace latchwork::icarus::testing {
namespace {

using ::testing::ElementsAre;

class FactStoreTest : public ::testing::Test {
 protected:
  Value List(const std::vector<std::int64_t>& items) {
    std::vector<Value> values = {Value::Symbol(names_.Intern("p"))};
    for (const std::int64_t item : items) values.push_back(Value::Integer(item));
    return arena_.MakeList(values);
  }
  std::vector<std::string> All() const { return Texts(memory_.First(), FactStore::Chain::kAll); }
  std::vector<std::string> Texts(const FactStore::Fact* fact, FactStore::Chain chain) const {
    std::vector<std::string> texts;
    for (; fact != nullptr; fact = FactStore::Next(fact, chain)) {
      if (fact->died == 0) texts.push_back(ToString(fact->value, names_));
    }
    return texts;
  }

  NamePool names_;
  Arena arena_;
  FactStore memory_;
};

TEST_F(FactStoreTest, HeldFactsStandInTheirPlaces) {
  memory_.Store(List({1}));
  const std::uint64_t first = memory_.OpenPlace();
  const std::uint64_t second = memory_.OpenPlace();
  memory_.Store(List({9}));
  memory_.Hold(List({5}), second, nullptr);
  memory_.Hold(List({4}), first + 1, nullptr);
  memory_.Hold(List({3}), first, nullptr);
  EXPECT_THAT(All(), ElementsAre("(p 1)", "(p 3)", "(p 4)", "(p 5)", "(p 9)"));
  EXPECT_EQ(Texts(memory_.First(names_.Intern("p"), 2), FactStore::Chain::kHead), All());
}

TEST_F(FactStoreTest, HeldFactsThatAreForgottenReturnWithTidy) {
  const auto* const fact = memory_.Hold(List({1}), memory_.OpenPlace(), nullptr);
  memory_.Remove(fact);
  EXPECT_FALSE(memory_.Holds(List({1})));
  memory_.Tidy();
  EXPECT_TRUE(memory_.Holds(List({1})));
  memory_.Release(fact);
  memory_.Tidy();
  EXPECT_THAT(All(), ElementsAre());
}

TEST_F(FactStoreTest, StoredFactsStayWhenReleased) {
  const auto* const fact = memory_.Hold(List({1}), memory_.OpenPlace(), nullptr);
  memory_.Store(List({1}));
  memory_.Release(fact);
  memory_.Tidy();
  EXPECT_THAT(All(), ElementsAre("(p 1)"));
}

/// What memory must hold, as a plain list.
class Model {
 public:
  void Store(const std::string& fact) {
    if (!Has(fact)) facts_.push_back(fact);
  }
  void Remove(const std::string& fact) { std::erase(facts_, fact); }
  void Replace(const std::string& fact, const std::string& by) {
    const auto at = std::find(facts_.begin(), facts_.end(), fact);
    if (at == facts_.end() || fact == by) return;
    if (Has(by)) {
      facts_.erase(at);
    } else {
      *at = by;
    }
  }
  const std::vector<std::string>& facts() const { return facts_; }

 private:
  bool Has(const std::string& fact) const {
    return std::find(facts_.begin(), facts_.end(), fact) != facts_.end();
  }
  std::vector<std::string> facts_;
};

TEST_F(FactStoreTest, RandomChanges_KeepOrderAndIndices) {
  const sdk::RandomStream random(7, "facts");
  Model model;
  for (std::uint64_t step = 0; step < 3000; ++step) {
    const auto draw = [&](std::uint64_t number, std::uint64_t count) {
      return static_cast<std::int64_t>(random.Index(count, step, number));
    };
    const Value fact = List({draw(0, 6), draw(1, 4)});
    const Value other = List({draw(2, 6), draw(3, 4)});
    const std::string text = ToString(fact, names_);
    switch (draw(4, 5)) {
      case 0:
      case 1:
        memory_.Store(fact);
        model.Store(text);
        break;
      case 2:
        if (const auto* known = memory_.Find(fact)) memory_.Remove(known);
        model.Remove(text);
        break;
      case 3:
        if (const auto* known = memory_.Find(fact)) memory_.Replace(known, other);
        model.Replace(text, ToString(other, names_));
        break;
      default:
        memory_.Tidy();
    }
    ASSERT_EQ(All(), model.facts()) << "step " << step;
    ASSERT_EQ(memory_.size(), model.facts().size());
    std::vector<std::string> alike;
    const Value second = Value::Integer(draw(0, 6));
    for (const std::string& each : model.facts()) {
      if (each.starts_with("(p " + ToString(second, names_) + ' ')) alike.push_back(each);
    }
    const NameId head = names_.Intern("p");
    ASSERT_EQ(Texts(memory_.First(head, 3), FactStore::Chain::kHead), model.facts());
    ASSERT_EQ(Texts(memory_.First(head, 3, second), FactStore::Chain::kSecond), alike);
  }
}

TEST_F(FactStoreTest, ManySecondItemsTakeNoMoreAndMore) {
  for (std::int64_t i = 0; i < 200'000; ++i) {
    memory_.Store(List({i}));
    memory_.Remove(memory_.Find(List({i})));
    memory_.Tidy();
    arena_.Reset();
  }
  EXPECT_EQ(memory_.First(names_.Intern("p"), 2), nullptr);
  EXPECT_EQ(memory_.size(), 0U);
}

}  // namespace
}  // namespace latchwork::icarus::testing

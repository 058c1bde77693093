// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/logic/symbol.h"

#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <vector>

namespace latchwork::logic {
namespace {

TEST(SymbolTest, Intern_SameName_GivesSameSymbol) {
  SymbolTable table;
  const Symbol a = table.Intern("sonar");
  EXPECT_EQ(a, table.Intern(std::string("so") + "nar"));
  EXPECT_NE(a, table.Intern("pose"));
  EXPECT_EQ(a.name(), "sonar");
  EXPECT_EQ(table.size(), 2U);
}

TEST(SymbolTest, Intern_DistinctObject_IsNoWord) {
  SymbolTable table;
  EXPECT_NE(table.Intern("a"), table.Intern("a", SymbolKind::kDistinctObject));
}

TEST(SymbolTest, Order_IsByName) {
  SymbolTable table;
  const Symbol b = table.Intern("b");
  const Symbol a = table.Intern("a");
  EXPECT_LT(a, b);
  EXPECT_LT(Symbol(), a);
  EXPECT_LT(a, table.Intern("a", SymbolKind::kDistinctObject));
}

TEST(SymbolTest, DefaultMade_IsNull) {
  EXPECT_FALSE(Symbol());
  EXPECT_EQ(Symbol().name(), "");
}

TEST(SymbolTest, Fresh_AvoidsKnownNames) {
  SymbolTable table;
  table.Intern("sk_1");
  EXPECT_EQ(table.Fresh("sk_").name(), "sk_2");
  EXPECT_EQ(table.Fresh("sk_").name(), "sk_3");
  EXPECT_EQ(table.Fresh("def_").name(), "def_1");
}

TEST(SymbolTest, Intern_FromManyThreads_AgreesOnSymbols) {
  SymbolTable table;
  constexpr std::size_t kNames = 500;
  std::vector<std::vector<Symbol>> seen(4);
  std::vector<std::thread> threads;
  for (auto& mine : seen) {
    threads.emplace_back([&table, &mine] {
      for (std::size_t i = 0; i < kNames; ++i) {
        mine.push_back(table.Intern("n" + std::to_string(i)));
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(table.size(), kNames);
  for (const auto& mine : seen) EXPECT_EQ(mine, seen[0]);
}

}  // namespace
}  // namespace latchwork::logic

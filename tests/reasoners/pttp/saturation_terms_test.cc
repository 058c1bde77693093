// SPDX-License-Identifier: BSD-3-Clause
// The laws of the term ordering, of unification and of the indexes, on random terms.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "reasoners/pttp/saturation/active_set.h"
#include "reasoners/pttp/saturation/fingerprint_index.h"
#include "reasoners/pttp/saturation/ordering.h"
#include "reasoners/pttp/saturation/substitution.h"
#include "reasoners/pttp/saturation/subsumption.h"
#include "tests/reasoners/pttp/saturation_fixture.h"

namespace latchwork::pttp::saturation {
namespace {

constexpr std::uint64_t kRounds = 3000;

TermId Tower(SmallSignature& signature, TermId top, std::size_t height) {
  for (std::size_t i = 0; i < height; ++i) {
    top = signature.terms.Make(signature.functors[2], std::vector{top});
  }
  return top;
}

TEST(SaturationTermsTest, Make_EqualTerms_AreShared) {
  SmallSignature s;
  const TermId a = s.terms.Make(s.functors[0], {});
  EXPECT_EQ(Tower(s, a, 5000), Tower(s, a, 5000));
  EXPECT_NE(Tower(s, a, 5000), Tower(s, a, 4999));
}

TEST(SaturationTermsTest, Rollback_NewTerms_AreForgottenAndMadeAgain) {
  SmallSignature s;
  const TermId a = s.terms.Make(s.functors[0], {});
  const TermId low = Tower(s, a, 10);
  const std::size_t mark = s.terms.Mark();
  const TermId high = Tower(s, a, 5000);
  s.terms.Rollback(mark);
  EXPECT_EQ(s.terms.Mark(), mark);
  EXPECT_EQ(Tower(s, a, 10), low);
  EXPECT_EQ(Tower(s, a, 5000), high);
}

TEST(SaturationOrderingTest, Compare_RandomTerms_IsAnOrder) {
  SmallSignature s;
  Ordering ordering(s.terms);
  for (std::uint64_t round = 0; round < kRounds; ++round) {
    Draws draws(round);
    const TermId a = s.Random(draws, 3);
    const TermId b = s.Random(draws, 3);
    const TermId c = s.Random(draws, 3);
    EXPECT_EQ(ordering.Compare(a, a), Order::kEqual);
    EXPECT_EQ(ordering.Compare(a, b), Reverse(ordering.Compare(b, a)));
    if (ordering.Greater(a, b) && ordering.Greater(b, c)) {
      EXPECT_TRUE(ordering.Greater(a, c));
    }
  }
}

TEST(SaturationOrderingTest, Compare_GroundTerms_IsTotal) {
  SmallSignature s;
  Ordering ordering(s.terms);
  Matcher ground(s.terms);
  for (std::uint32_t i = 0; i < 3; ++i) ground.Bind(i, s.terms.Make(s.functors[i % 2], {}));
  for (std::uint64_t round = 0; round < kRounds; ++round) {
    Draws draws(round);
    const TermId a = ground.Apply(s.Random(draws, 3));
    const TermId b = ground.Apply(s.Random(draws, 3));
    EXPECT_NE(ordering.Compare(a, b), Order::kIncomparable);
  }
}

TEST(SaturationOrderingTest, Greater_UnderSubstitution_Stays) {
  SmallSignature s;
  Ordering ordering(s.terms);
  std::size_t seen = 0;
  for (std::uint64_t round = 0; round < kRounds; ++round) {
    Draws draws(round);
    const TermId a = s.Random(draws, 3);
    const TermId b = s.Random(draws, 3);
    if (!ordering.Greater(a, b)) continue;
    ++seen;
    Matcher matcher(s.terms);
    for (std::uint32_t i = 0; i < 3; ++i) matcher.Bind(i, s.Random(draws, 2));
    EXPECT_TRUE(ordering.Greater(matcher.Apply(a), matcher.Apply(b)));
  }
  EXPECT_GT(seen, kRounds / 10);
}

TEST(SaturationOrderingTest, Greater_Subterms_AreLess) {
  SmallSignature s;
  Ordering ordering(s.terms);
  for (std::uint64_t round = 0; round < kRounds; ++round) {
    Draws draws(round);
    const TermId term = s.Random(draws, 4);
    std::vector<TermId> subterms;
    CollectSubterms(s.terms, term, subterms);
    for (const TermId subterm : subterms) {
      EXPECT_EQ(ordering.Greater(term, subterm), subterm != term);
    }
  }
}

TEST(SaturationOrderingTest, Compare_DeepTerms_DoesNotOverflow) {
  SmallSignature s;
  Ordering ordering(s.terms);
  const TermId x = Tower(s, Terms::Variable(0), 200'000);
  EXPECT_EQ(ordering.Compare(x, Tower(s, Terms::Variable(1), 200'000)), Order::kIncomparable);
  EXPECT_EQ(ordering.Compare(x, Tower(s, Terms::Variable(0), 100'000)), Order::kGreater);
}

TEST(SaturationOrderingTest, Compare_Literals_NegativeExceedsItsAtom) {
  SmallSignature s;
  Ordering ordering(s.terms);
  Literal atom;
  atom.left = s.terms.Make(s.functors[2], std::vector{Terms::Variable(0)});
  Literal negated = atom;
  negated.positive = false;
  EXPECT_EQ(ordering.Compare(negated, atom), Order::kGreater);
  EXPECT_EQ(ordering.Compare(atom, negated), Order::kLess);
}

TEST(SaturationSubstitutionTest, Unify_RandomTerms_MakesThemEqual) {
  SmallSignature s;
  std::size_t unified = 0;
  for (std::uint64_t round = 0; round < kRounds; ++round) {
    Draws draws(round);
    const Item a{s.Random(draws, 3), 0};
    const Item b{s.Random(draws, 3), 1};
    Substitution substitution(s.terms);
    if (!substitution.Unify(a, b)) continue;
    ++unified;
    EXPECT_EQ(substitution.Apply(a), substitution.Apply(b));
  }
  EXPECT_GT(unified, kRounds / 10);
}

TEST(SaturationSubstitutionTest, Unify_VariableInItself_Fails) {
  SmallSignature s;
  Substitution substitution(s.terms);
  const TermId x = Terms::Variable(0);
  EXPECT_FALSE(substitution.Unify({x, 0}, {Tower(s, x, 1), 0}));
  substitution.Reset();
  EXPECT_TRUE(substitution.Unify({x, 0}, {Tower(s, x, 1), 1}));
}

TEST(SaturationIndexTest, Search_RandomTerms_FindsWhatNaiveSearchFinds) {
  SmallSignature s;
  FingerprintIndex index(s.terms);
  std::vector<TermId> indexed;
  Draws draws(0);
  for (ClauseId i = 0; i < 300; ++i) {
    indexed.push_back(s.Random(draws, 3));
    index.Insert({indexed.back(), i, 0, true});
  }
  for (ClauseId i = 0; i < 300; i += 3) index.Erase({&indexed[i], 1}, i);
  Matcher matcher(s.terms);
  Substitution substitution(s.terms);
  const auto fits = [&](Fit fit, TermId query, TermId term) {
    substitution.Reset();
    if (fit == Fit::kUnifiable) return substitution.Unify({query, 0}, {term, 1});
    const bool matches =
        fit == Fit::kInstance ? matcher.Match(query, term) : matcher.Match(term, query);
    matcher.Undo(0);
    return matches;
  };
  for (int round = 0; round < 200; ++round) {
    const TermId query = s.Random(draws, 3);
    for (const Fit fit : {Fit::kUnifiable, Fit::kGeneralization, Fit::kInstance}) {
      std::vector<ClauseId> found;
      index.Search(fit, query, [&](const Occurrence& o) {
        if (fits(fit, query, o.term)) found.push_back(o.clause);
        return false;
      });
      std::vector<ClauseId> expected;
      for (ClauseId i = 0; i < 300; ++i) {
        if (i % 3 != 0 && fits(fit, query, indexed[i])) expected.push_back(i);
      }
      std::ranges::sort(found);
      EXPECT_EQ(found, expected);
    }
  }
}

std::vector<Literal> RandomClause(SmallSignature& s, Draws& draws) {
  std::vector<Literal> clause(1 + draws.Pick(3));
  for (Literal& literal : clause) {
    literal.positive = draws.Pick(2) == 0;
    literal.left = s.Random(draws, 2);
    if (draws.Pick(2) == 0) literal.right = s.Random(draws, 1);
  }
  return clause;
}

/// Tries all ways to map the literals, without any index or order.
bool NaiveSubsumes(Matcher& matcher, std::vector<Literal> general, std::vector<Literal> special) {
  if (general.empty()) return true;
  const Literal first = general.back();
  general.pop_back();
  for (std::size_t i = 0; i < special.size(); ++i) {
    const Literal target = special[i];
    if (target.positive != first.positive || target.is_equation() != first.is_equation()) continue;
    auto rest = special;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
    for (const bool turned : {false, true}) {
      if (turned && !first.is_equation()) continue;
      const std::size_t mark = matcher.Mark();
      const bool covered = matcher.Match(first.left, turned ? target.right : target.left) &&
                           matcher.Match(first.right, turned ? target.left : target.right) &&
                           NaiveSubsumes(matcher, general, rest);
      matcher.Undo(mark);
      if (covered) return true;
    }
  }
  return false;
}

TEST(SaturationIndexTest, SearchSubsumers_RandomClauses_AgreesWithNaiveSubsumption) {
  SmallSignature s;
  FeatureIndex index(s.terms);
  Subsumer subsumer(s.terms);
  Matcher matcher(s.terms);
  std::vector<std::vector<Literal>> clauses;
  Draws draws(1);
  for (ClauseId i = 0; i < 200; ++i) {
    clauses.push_back(RandomClause(s, draws));
    index.Insert(i, clauses.back());
  }
  std::size_t total = 0;
  for (const auto& query : clauses) {
    std::vector<ClauseId> found;
    index.SearchSubsumers(query, [&](ClauseId id) {
      if (subsumer.Subsumes(clauses[id], query)) found.push_back(id);
      return false;
    });
    std::ranges::sort(found);
    std::vector<ClauseId> expected;
    for (ClauseId i = 0; i < 200; ++i) {
      if (NaiveSubsumes(matcher, clauses[i], query)) expected.push_back(i);
    }
    EXPECT_EQ(found, expected);
    total += found.size();
  }
  EXPECT_GT(total, 220U);
}

}  // namespace
}  // namespace latchwork::pttp::saturation

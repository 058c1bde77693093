// SPDX-License-Identifier: BSD-3-Clause
//
// The syntax files of editors know every word of the language.
#if defined(__GNUC__) && !defined(__clang__)
// Where code is instrumented, GCC suspects values within its own <regex>.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include "reasoners/icarus/language/program.h"
#include "reasoners/icarus/language/signature.h"

namespace latchwork::icarus::testing {
namespace {

using nlohmann::json;

std::string ReadEditorFile(const std::string& name) {
  std::ifstream stream(std::filesystem::path(LATCHWORK_SOURCE_DIR) / "editors" / name);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Case is set by (?i: ), which the regular expressions of the standard library do not know.
std::regex Expression(std::string pattern) {
  const bool folds = pattern.starts_with("(?i:");
  if (folds) pattern.replace(0, 4, "(?:");
  return std::regex(pattern, folds ? std::regex::icase : std::regex::ECMAScript);
}

/// The scope that the grammar gives to a piece of text: of its first group, or of all of it.
std::string ScopeOf(const std::string& text) {
  const json grammar = json::parse(ReadEditorFile("vscode/syntaxes/icarus.tmLanguage.json"));
  for (const json& pattern : grammar.at("patterns")) {
    if (!pattern.contains("match")) continue;
    if (!std::regex_search(text, Expression(pattern.at("match")),
                           std::regex_constants::match_continuous)) {
      continue;
    }
    return pattern.contains("captures") ? pattern["captures"]["1"]["name"] : pattern["name"];
  }
  return "";
}

TEST(IcarusEditorsTest, JsonFiles_AreWellFormedAndNameEachOther) {
  const json package = json::parse(ReadEditorFile("vscode/package.json"));
  const json& contributes = package.at("contributes");
  const json& language = contributes.at("languages").at(0);
  const json& grammar = contributes.at("grammars").at(0);
  EXPECT_EQ(language.at("id"), grammar.at("language"));
  const std::string path = grammar.at("path");
  EXPECT_EQ(json::parse(ReadEditorFile("vscode/" + path)).at("scopeName"), grammar.at("scopeName"));
  const std::string configuration = language.at("configuration");
  EXPECT_EQ(json::parse(ReadEditorFile("vscode/" + configuration))["comments"]["lineComment"], ";");
}

TEST(IcarusEditorsTest, TextMateGrammar_KnowsEveryWord) {
  for (std::size_t i = 0; i < kSlots; ++i) {
    const std::string keyword(KeywordOf(static_cast<Slot>(i)));
    EXPECT_EQ(ScopeOf(keyword + " ("), "keyword.other.slot.icarus") << keyword;
  }
  EXPECT_EQ(ScopeOf(":value 3"), "keyword.other.slot.icarus");
  for (const Signature& builtin : BuiltinSignatures()) {
    EXPECT_EQ(ScopeOf("{" + std::string(builtin.name) + " ?x"), "support.function.builtin.icarus")
        << builtin.name;
  }
  for (const char* clause : {"(bind ?x", "(*not* (", "(*notA* ("}) {
    EXPECT_EQ(ScopeOf(clause), "keyword.operator.clause.icarus") << clause;
  }
  for (const char* form : {"(constant *N* 1)", "(facts (a))", "(top (Go))", "(cycle)"}) {
    EXPECT_EQ(ScopeOf(form), "keyword.control.form.icarus") << form;
  }
  EXPECT_EQ(ScopeOf("{range-to ?car}"), "entity.name.function.host.icarus");
  EXPECT_EQ(ScopeOf("{storey ?car}"), "entity.name.function.host.icarus");
  EXPECT_EQ(ScopeOf("(Near (?car)"), "entity.name.type.skill.icarus");
  EXPECT_EQ(ScopeOf("?car"), "variable.parameter.icarus");
  EXPECT_EQ(ScopeOf("*Hard*"), "constant.other.icarus");
  EXPECT_EQ(ScopeOf("-1.5e3)"), "constant.numeric.icarus");
  EXPECT_EQ(ScopeOf("; anything"), "comment.line.semicolon.icarus");
}

TEST(IcarusEditorsTest, VimSyntax_KnowsEveryWord) {
  const std::string syntax = ReadEditorFile("vim/syntax/icarus.vim");
  const auto holds = [&](std::string_view word) {
    std::string escaped;
    for (const char c : word)
      escaped += c == '*' || c == '/' ? std::string("\\") + c : std::string(1, c);
    for (const char* end : {"\\|", "\\)"}) {
      for (const char* begin : {"\\|", "\\("}) {
        if (syntax.find(begin + escaped + end) != std::string::npos) return true;
      }
    }
    return false;
  };
  for (std::size_t i = 0; i < kSlots; ++i) {
    const std::string_view keyword = KeywordOf(static_cast<Slot>(i));
    EXPECT_TRUE(holds(keyword.substr(1))) << keyword;
  }
  for (const Signature& builtin : BuiltinSignatures()) {
    EXPECT_TRUE(holds(builtin.name)) << builtin.name;
  }
  for (const char* word :
       {"value", "constant", "facts", "top", "never", "bind", "*not*", "*nota*"}) {
    EXPECT_TRUE(holds(word)) << word;
  }
  EXPECT_NE(ReadEditorFile("vim/ftdetect/icarus.vim").find("*.icarus"), std::string::npos);
  EXPECT_NE(ReadEditorFile("vim/indent/icarus.vim").find("setlocal lisp"), std::string::npos);
}

}  // namespace
}  // namespace latchwork::icarus::testing

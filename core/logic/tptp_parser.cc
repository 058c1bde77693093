// SPDX-License-Identifier: BSD-3-Clause
#include "core/logic/tptp_parser.h"

#include <algorithm>
#include <array>
#include <utility>

namespace latchwork::logic {

namespace {

using Kind = TptpToken::Kind;

struct KnownRole {
  std::string_view name;
  Role role;
};

constexpr std::array kRoles = {
    KnownRole{"axiom", Role::kAxiom},
    KnownRole{"hypothesis", Role::kAxiom},
    KnownRole{"definition", Role::kAxiom},
    KnownRole{"assumption", Role::kAxiom},
    KnownRole{"lemma", Role::kAxiom},
    KnownRole{"theorem", Role::kAxiom},
    KnownRole{"corollary", Role::kAxiom},
    KnownRole{"plain", Role::kAxiom},
    KnownRole{"conjecture", Role::kConjecture},
    KnownRole{"question", Role::kConjecture},
    KnownRole{"negated_conjecture", Role::kNegatedConjecture},
};

constexpr std::array<std::string_view, 5> kSourceFunctions = {"inference", "introduced", "file",
                                                              "theory", "creator"};

std::optional<TptpLanguage> FindLanguage(std::string_view word) {
  if (word == "cnf") return TptpLanguage::kCnf;
  if (word == "fof") return TptpLanguage::kFof;
  if (word == "tff") return TptpLanguage::kTff;
  return std::nullopt;
}

std::string RoleHint(std::string_view word) {
  std::vector<std::string> names;
  std::string all;
  for (const KnownRole& each : kRoles) {
    names.emplace_back(each.name);
    all += (all.empty() ? "" : ", ") + std::string(each.name);
  }
  const std::string_view nearest = NearestName(word, names);
  return nearest.empty() ? "roles are " + all : "did you mean '" + std::string(nearest) + "'?";
}

}  // namespace

TptpParser::TptpParser(std::string_view text, std::string_view name, SymbolTable& symbols,
                       const TptpOptions& options, TptpFile& result, TptpTypes& types,
                       IncludeHandler include)
    : cursor_(text, name, options.max_tokens, result.diagnostics),
      formulas_(cursor_, symbols),
      options_(options),
      result_(result),
      types_(types),
      symbols_(symbols),
      include_(std::move(include)) {}

void TptpParser::Read() {
  while (!cursor_.Is(Kind::kEnd) && result_.diagnostics.size() < options_.max_diagnostics) {
    if (!ReadInput()) Recover();
  }
}

bool TptpParser::ReadInput() {
  const std::string_view word = cursor_.token().text;
  const auto language = FindLanguage(word);
  if (!language && word != "include") return FailLanguage();
  cursor_.Advance();
  if (!cursor_.Expect(Kind::kLeftParenthesis, "'(' after '" + std::string(word) + "'")) {
    return false;
  }
  return language ? ReadAnnotated(*language) : ReadInclude();
}

bool TptpParser::FailLanguage() {
  const std::string word(cursor_.token().text);
  std::string hint;
  if (word == "thf" || word == "tcf" || word == "tpi") {
    hint = "the languages read are cnf, fof and tff";
  } else if (cursor_.Is(Kind::kLowerWord)) {
    const std::vector<std::string> languages = {"cnf", "fof", "tff", "include"};
    const std::string_view nearest = NearestName(word, languages);
    hint = nearest.empty() ? "a formula reads fof(name, axiom, p(a))."
                           : "did you mean '" + std::string(nearest) + "'?";
  }
  return cursor_.FailExpected("cnf, fof, tff or include", hint);
}

bool TptpParser::ReadAnnotated(TptpLanguage language) {
  AnnotatedFormula annotated;
  annotated.place = cursor_.place();
  annotated.is_clause = language == TptpLanguage::kCnf;
  std::optional<Role> role;
  if (!ReadName(annotated.name) || !cursor_.Expect(Kind::kComma, "',' after the name") ||
      !ReadRole(language, role) || !cursor_.Expect(Kind::kComma, "',' after the role")) {
    return false;
  }
  if (!role) return ReadTypeDeclaration({annotated.name, {}, {}, {}, annotated.place});
  annotated.role = *role;
  std::string_view source;
  const char* const begin = cursor_.token().text.data();
  if (!ReadFormula(language, annotated)) return false;
  const char* const end = cursor_.token().text.data();
  if (!ReadAnnotations(source) || !ReadEnd()) return false;
  result_.formulas.push_back(std::move(annotated));
  types_.variables.emplace_back();
  if (language == TptpLanguage::kTff) types_.variables.back() = formulas_.VariableTypes();
  if (options_.keep_sources) result_.sources.emplace_back(source);
  if (options_.keep_texts) {
    result_.texts.emplace_back(begin, language == TptpLanguage::kTff ? begin : end);
  }
  return true;
}

bool TptpParser::ReadName(std::string& name) {
  const std::string_view text = cursor_.token().text;
  if (cursor_.Is(Kind::kQuoted)) {
    name = Unquote(text);
  } else if (cursor_.Is(Kind::kLowerWord) || cursor_.Is(Kind::kInteger)) {
    name = text;
  } else {
    return cursor_.FailExpected(
        "a name", cursor_.Is(Kind::kUpperWord)
                      ? "names begin with a lower-case letter or stand in single quotes"
                      : "");
  }
  cursor_.Advance();
  return true;
}

/// No role: a type declaration.
bool TptpParser::ReadRole(TptpLanguage language, std::optional<Role>& role) {
  const std::string_view text = cursor_.token().text;
  const auto found = std::find_if(kRoles.begin(), kRoles.end(),
                                  [&](const KnownRole& each) { return each.name == text; });
  const bool is_type = text == "type" && language == TptpLanguage::kTff;
  if (!cursor_.Is(Kind::kLowerWord)) return cursor_.FailExpected("a role such as 'axiom'");
  if (text == "type" && !is_type) {
    return cursor_.Fail("types belong to tff", "write tff(...) for a type declaration");
  }
  if (found == kRoles.end() && !is_type) {
    return cursor_.Fail("unknown role '" + std::string(text.substr(0, 40)) + "'", RoleHint(text));
  }
  if (found != kRoles.end()) role = found->role;
  result_.asks = result_.asks || text == "question";
  cursor_.Advance();
  return !cursor_.Accept(Kind::kMinus) || SkipBalanced(true);
}

bool TptpParser::ReadFormula(TptpLanguage language, AnnotatedFormula& annotated) {
  auto formula = formulas_.Read(language);
  if (!formula) return false;
  annotated.formula = std::move(*formula);
  annotated.variable_names = formulas_.VariableNames();
  return true;
}

bool TptpParser::ReadAnnotations(std::string_view& source) {
  if (!cursor_.Accept(Kind::kComma)) return true;
  const char* const begin = cursor_.token().text.data();
  if (!SkipAnnotations()) return false;
  source = {begin, static_cast<std::size_t>(cursor_.token().text.data() - begin)};
  return true;
}

bool TptpParser::SkipAnnotations() {
  if (!cursor_.Is(Kind::kLowerWord)) return SkipBalanced(false);
  const SourcePlace place = cursor_.place();
  const std::string_view word = cursor_.token().text;
  cursor_.Advance();
  const bool known =
      std::find(kSourceFunctions.begin(), kSourceFunctions.end(), word) != kSourceFunctions.end();
  if (cursor_.Is(Kind::kLeftParenthesis) && !known) {
    return cursor_.FailAt(place, "after the formula comes its source, such as file('...')",
                          "TPTP writes conjunction as '&', not ','");
  }
  return SkipBalanced(false);
}

bool TptpParser::ReadTypeDeclaration(TptpDeclaration declaration) {
  std::size_t open = 0;
  while (cursor_.Accept(Kind::kLeftParenthesis)) ++open;
  std::string symbol;
  if (!ReadName(symbol)) return false;
  declaration.symbol = symbols_.Intern(symbol);
  if (!cursor_.Expect(Kind::kColon, "':' and the type", "a declaration reads p: $i > $o")) {
    return false;
  }
  if (!ReadFunctionType(declaration)) return false;
  for (; open > 0; --open) {
    if (!cursor_.Expect(Kind::kRightParenthesis, "')'")) return false;
  }
  std::string_view source;
  if (!ReadAnnotations(source) || !ReadEnd()) return false;
  types_.declarations.push_back(std::move(declaration));
  return true;
}

bool TptpParser::ReadFunctionType(TptpDeclaration& declaration) {
  std::size_t open = 0;
  while (cursor_.Accept(Kind::kLeftParenthesis)) ++open;
  if (!ReadResultType(declaration)) return false;
  std::vector<TptpType> types = {declaration.result};
  const auto close = [&] {
    while (open > 0 && cursor_.Accept(Kind::kRightParenthesis)) --open;
  };
  while (open > 0 && cursor_.Accept(Kind::kStar)) {
    if (!ReadTptpType(cursor_, types.emplace_back())) return false;
  }
  close();
  if (cursor_.token().text == ">") {
    cursor_.Advance();
    if (!ReadResultType(declaration)) return false;
    close();
    declaration.arguments = std::move(types);
  } else if (types.size() > 1) {
    return cursor_.FailExpected("'>' and the type of the result",
                                "a predicate of two arguments is ($i * $i) > $o");
  }
  if (std::find(declaration.arguments.begin(), declaration.arguments.end(), TptpType::kTruth) !=
      declaration.arguments.end()) {
    return cursor_.Fail("a truth value is no argument", "$o is the type of what a predicate gives");
  }
  return open == 0 || cursor_.FailExpected("')'");
}

bool TptpParser::ReadResultType(TptpDeclaration& declaration) {
  if (cursor_.token().text == "$tType") {
    return cursor_.Fail("types of one's own are not supported",
                        "the types known are $i, $int and $real");
  }
  if (cursor_.token().text != "$o") return ReadTptpType(cursor_, declaration.result);
  declaration.result = TptpType::kTruth;
  cursor_.Advance();
  return true;
}

bool TptpParser::SkipBalanced(bool to_comma) {
  std::string closers;
  while (true) {
    const Kind kind = cursor_.kind();
    if (kind == Kind::kEnd || kind == Kind::kBad) return cursor_.FailExpected("')'");
    if (kind == Kind::kRightParenthesis || kind == Kind::kRightBracket) {
      const char closer = cursor_.token().text[0];
      if (closers.empty() && closer == ')') return true;
      if (closers.empty() || closers.back() != closer) {
        return cursor_.Fail(cursor_.Found() + " closes nothing that is open");
      }
      closers.pop_back();
    } else if (kind == Kind::kComma && to_comma && closers.empty()) {
      return true;
    } else if (kind == Kind::kLeftParenthesis || kind == Kind::kLeftBracket) {
      closers += kind == Kind::kLeftParenthesis ? ')' : ']';
    }
    cursor_.Advance();
  }
}

bool TptpParser::ReadEnd() {
  const std::string_view hint = cursor_.Is(Kind::kDot) ? "a '(' is not closed" : "";
  if (!cursor_.Expect(Kind::kRightParenthesis, "a connective or ')'", hint)) return false;
  return cursor_.Expect(Kind::kDot, "'.'", "every annotated formula ends with ').'");
}

bool TptpParser::ReadInclude() {
  const SourcePlace place = cursor_.place();
  TptpInclude include;
  if (!cursor_.Is(Kind::kQuoted)) {
    return cursor_.FailExpected("a file name in single quotes",
                                "an include reads include('Axioms/groups.ax').");
  }
  include.file = Unquote(cursor_.token().text);
  cursor_.Advance();
  if (cursor_.Accept(Kind::kComma) && !ReadSelection(include)) return false;
  if (cursor_.Accept(Kind::kComma) && !SkipBalanced(false)) return false;
  if (!ReadEnd()) return false;
  if (auto fault = include_(include)) {
    cursor_.FailAt(place, std::move(fault->message), std::move(fault->hint));
  }
  return true;
}

bool TptpParser::ReadSelection(TptpInclude& include) {
  if (cursor_.Accept(Kind::kStar)) return true;
  if (!cursor_.Expect(Kind::kLeftBracket, "'[' and the names of formulas")) return false;
  include.selection.emplace();
  if (cursor_.Accept(Kind::kRightBracket)) return true;
  do {
    if (!ReadName(include.selection->emplace_back())) return false;
  } while (cursor_.Accept(Kind::kComma));
  return cursor_.Expect(Kind::kRightBracket, "',' or ']'");
}

/// Behind the next `).`, or at the next line that begins an annotated formula.
void TptpParser::Recover() {
  bool after_parenthesis = false;
  for (; !cursor_.Is(Kind::kEnd); cursor_.Advance()) {
    const TptpToken& token = cursor_.token();
    if (after_parenthesis && token.kind == Kind::kDot) return cursor_.Advance();
    if (token.first_on_line && (token.text == "include" || FindLanguage(token.text))) return;
    after_parenthesis = token.kind == Kind::kRightParenthesis;
  }
}

}  // namespace latchwork::logic

// SPDX-License-Identifier: BSD-3-Clause
#include <array>

#include "reasoners/icarus/language/finding.h"

namespace latchwork::icarus {

namespace {

constexpr Severity kError = Severity::kError;
constexpr Severity kWarning = Severity::kWarning;

/// In the order of Code. A name, once published, keeps its meaning.
constexpr std::array<CodeInfo, 36> kCodes = {{
    {"I001", kError,
     "A bracket is missing, superfluous or of the wrong kind. Lists stand in ( ), calls of host "
     "functions in { }."},
    {"I002", kError,
     "This is no token of the language: a character that cannot be part of a name, a string that "
     "is not closed on its line, or a number that does not fit into 64 bits."},
    {"I003", kError, "Brackets may nest to a depth of 1000."},
    {"I004", kError,
     "A program is made of skills, (NAME (?x ...) :slot ...), of constants, (constant *NAME* "
     "value), of initial facts, (facts (head ...) ...), and of its top call, (top (NAME ...))."},
    {"I005", kError,
     "A skill begins with its name and the list of its parameters, which are different variables: "
     "(Near (?car) ...)."},
    {"I006", kError,
     "The slots are :objective :requires :means :sequence :action :sensor and :value."},
    {"I007", kError,
     "Each slot stands once, followed by one list; :value is followed by a number or a call."},
    {"I008", kError,
     "A skill is of one type: a plan (:objective, :requires, :means), a sequence, an action or a "
     "sensor. :value may be added to any."},
    {"I009", kError, "Names of skills are unique; upper and lower case are the same."},
    {"I010", kError,
     "A clause is a call of a skill or a match form in ( ), a call of a host function in { }, "
     "(bind ?v term), (*not* clause) or (*notA* clause). An action holds calls only, a sensor "
     "calls and bind."},
    {"I011", kError, "A skill is called with more arguments than it has parameters."},
    {"I012", kError,
     "A constant is defined once, (constant *NAME* value), with a ground value, and is defined "
     "before it is used in another constant. *cycle* is the number of the present cycle."},
    {"I013", kError, "A fact is a list without variables and calls: (driver car1 anna)."},
    {"I014", kWarning,
     "A skill is called with fewer arguments than it has parameters. The rest are unbound, and "
     "what they are bound to is lost."},
    {"I015", kWarning,
     "No skill has this name, so the clause asks short-term memory for a fact; but its name is "
     "nearly that of a skill."},
    {"I016", kWarning,
     "No skill has this name, so the clause asks short-term memory for a fact; but no fact of the "
     "program begins so, and nothing in it stores one. Of a program with a top, whose facts a "
     "layer may bring, and of one without facts, whose script may bring them, it is only said of "
     "means that are named like the skills, with a capital: a match never acts."},
    {"I017", kWarning,
     "A variable that stands once in a skill binds nothing and tests nothing; mostly it is a slip. "
     "Write ? or begin its name with an underscore, ?_x, where it is meant."},
    {"I018", kWarning, "No skill that could be the top of the program leads to this one."},
    {"I019", kWarning,
     "An empty :objective is True, so :requires and :means are never asked for. Nor are they where "
     "the :objective is always True or acts: the call of an :action acts whenever it is asked, and "
     "an objective that acts is not False."},
    {"I020", kWarning,
     "An act must have no unbound variables, or it is not offered and a fault is reported. Nothing "
     "before this clause binds the variable, or not each of the ways that lead here does: not all "
     "means by which a skill may be True, or not all calls of this skill from the top (with no "
     "top: "
     "from any skill). ? is never bound."},
    {"I021", kWarning,
     "A host function is called with values. Nothing before this clause binds the variable, or not "
     "each of the ways that lead here does (see I020), so the call is False and a fault is "
     "reported. ? is never bound."},
    {"I022", kWarning,
     "This means offers its act whenever it is asked; with acts = first, those after it are never "
     "chosen."},
    {"I023", kWarning,
     "The first thing that the skill asks for is, directly or through others, the skill itself; or "
     "it calls itself, directly or through others, with its own arguments, where nothing has "
     "changed: it ends at the limit of "
     "depth, with a fault."},
    {"I024", kWarning,
     "The state of a sequence is kept for the values of its parameters; nothing before this clause "
     "surely binds the variable (see I020), so all such calls share one state."},
    {"I025", kWarning,
     "Memory is changed where a clause is only asked whether it holds. Changes belong into "
     ":sensor and :action."},
    {"I026", kWarning,
     "The same name, of a skill, a constant, a function, a variable, of facts or of a symbol, is "
     "spelt with different letters in upper and lower case."},
    {"I027", kError,
     "The function takes another number of arguments, or others; or what it answers does not fit."},
    {"I028", kError, "The host offers no function of this name."},
    {"I029", kError,
     "A script of a world holds (top (Skill argument ...)), (functions name ...) and "
     "(cycle item ...), whose items are (answer {function argument ...} value), (fail {function "
     "argument ...} \"message\"), (store fact), (forget pattern), (update pattern fact), (top "
     "call), (idle), (repeat n) and (expect {act} "
     "... true|false|fault)."},
    {"I030", kError,
     "A program may name the call that every cycle begins with, once: (top (Skill argument "
     "...))."},
    {"I031", kError,
     "The layer's contract declares facts of this name with another number of arguments, or with "
     "others, so the match can never succeed."},
    {"I032", kError,
     "In a layer it is known which facts memory may hold: those of the contract, the parameters "
     "and what the program stores. The clause is neither a match of one of them nor the call of "
     "a skill."},
    {"I033", kError,
     "A file of plans holds (teleo-reactive Name (?x ...) (goal condition ...) (when condition ... "
     "do {act} ... (when ...) ...) ...) and (universal-plan Name (?x ...) (achieve condition ... "
     "(by {act} ... (if condition ...) (achieve ...) ...) ...)); conditions are {function ...}, "
     "(fact ...) and (not condition)."},
    {"I034", kError,
     "A file of learned values holds (value (Skill argument ...) estimate times), for skills of "
     "the "
     "program and as many arguments as they have parameters."},
    {"I035", kWarning,
     "What a skill does with a parameter, directly or through the skills that it calls, tells "
     "which "
     "values it may have: {<} compares numbers, {member} looks into a list. A value of another "
     "type makes those clauses False, with a fault."},
    {"I036", kWarning,
     "A call of an :action comes to an act and is never True, so what stands behind it is never "
     "asked: the next steps of a sequence, the clauses after it, the means. A step is a skill "
     "whose "
     ":objective tells when it is done, and whose :means is the act."},
}};

}  // namespace

const CodeInfo& Info(Code code) { return kCodes.at(static_cast<std::size_t>(code)); }

std::span<const CodeInfo> AllCodes() { return kCodes; }

}  // namespace latchwork::icarus

// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/tools/world_script.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "reasoners/icarus/language/reader.h"
#include "reasoners/icarus/tools/clause_text.h"

namespace latchwork::icarus {

namespace {

constexpr std::int64_t kMostRepeats = 1'000'000;

class ScriptReader {
 public:
  ScriptReader(const SourceTree& tree, NamePool& names, Findings& findings, WorldScript& script)
      : tree_(tree), names_(names), reporter_(tree, findings), script_(script) {}

  void Read() {
    for (const FormId root : tree_.roots) {
      const std::vector<FormId> parts = Parts(root);
      const std::string head = Head(root, parts);
      if (head == "top" && parts.size() == 2) {
        if (!script_.top.empty()) Complain(root, "the script has a top already");
        script_.top = tree_.Text(parts[1]);
        script_.top_place = tree_.Place(parts[1]);
      } else if (head == "functions") {
        for (std::size_t i = 1; i < parts.size(); ++i) {
          if (IsName(parts[i])) Function(tree_.Folded(parts[i]), kAnyNumber);
        }
      } else if (head == "cycle") {
        AddCycle(root, parts);
      } else {
        Complain(root, "this is no part of a script");
      }
    }
  }

 private:
  std::vector<FormId> Parts(FormId form) const {
    return tree_.kind(form) == FormKind::kList ? tree_.Children(form) : std::vector<FormId>();
  }

  std::string Head(FormId form, const std::vector<FormId>& parts) const {
    const bool named = !parts.empty() && tree_.kind(parts[0]) == FormKind::kSymbol &&
                       tree_.kind(form) == FormKind::kList;
    return named ? tree_.Folded(parts[0]) : std::string();
  }

  void Complain(FormId form, std::string message) {
    reporter_.Add(Code::kScript, form, std::move(message),
                  std::string(Info(Code::kScript).explanation));
  }

  /// Of a function of the world; what else it is, is reported.
  bool IsName(FormId form) {
    if (tree_.kind(form) != FormKind::kSymbol) {
      Complain(form, "this is no name of a function");
      return false;
    }
    if (FindBuiltin(tree_.Folded(form)) == nullptr) return true;
    Complain(form, "{" + tree_.Folded(form) + "} is part of the language: no world answers it");
    return false;
  }

  /// `count` arguments were seen, or any number may be.
  std::size_t Function(const std::string& name, std::size_t count) {
    auto& known = script_.functions;
    const auto found = std::find_if(known.begin(), known.end(),
                                    [&](const Signature& s) { return s.name == name; });
    if (found != known.end()) return static_cast<std::size_t>(found - known.begin());
    script_.names.push_back(name);
    Signature signature;
    signature.name = script_.names.back();
    if (count != kAnyNumber) signature.least = signature.most = count;
    known.push_back(signature);
    return known.size() - 1;
  }

  void AddCycle(FormId root, const std::vector<FormId>& parts) {
    ScriptCycle cycle;
    cycle.line = tree_.at(root).line;
    for (std::size_t i = 1; i < parts.size(); ++i) {
      if (!AddItem(cycle, parts[i])) Complain(parts[i], "this is no item of a cycle");
    }
    script_.cycles.push_back(std::move(cycle));
  }

  bool AddItem(ScriptCycle& cycle, FormId form) {
    const std::vector<FormId> parts = Parts(form);
    const std::string head = Head(form, parts);
    if (head == "expect") return AddExpectation(cycle, parts);
    if (head == "idle" && parts.size() == 1) return cycle.idle = true;
    if (head == "answer" && parts.size() == 3) return AddAnswer(cycle, parts);
    if (head == "fail" && parts.size() == 3) return AddFailure(cycle, parts);
    if (head == "update" && parts.size() == 3) return AddUpdate(cycle, parts);
    if (parts.size() != 2) return false;
    const FormKind kind = tree_.kind(parts[1]);
    if (head == "top") {
      cycle.top = std::string(tree_.Text(parts[1]));
      cycle.top_place = tree_.Place(parts[1]);
      return kind == FormKind::kList;
    }
    if (head == "repeat" && kind == FormKind::kInteger && cycle.repeat == 1) {
      cycle.repeat = tree_.at(parts[1]).integer;
      return cycle.repeat >= 1 && cycle.repeat <= kMostRepeats;
    }
    if (kind != FormKind::kList || (head != "store" && head != "forget")) return false;
    const Value list = MakeValue(parts[1]);
    if (list.is_none()) return false;
    (head == "store" ? cycle.stored : cycle.forgotten).push_back(list);
    return head == "forget" || IsGround(parts[1]);
  }

  bool AddAnswer(ScriptCycle& cycle, const std::vector<FormId>& parts) {
    if (!IsCall(parts[1]) || !IsGround(parts[2])) return false;
    std::optional<ScriptAnswer> answer = CallOf(parts[1]);
    if (!answer) return true;
    if (tree_.Folded(parts[2]) != "nil") answer->answer = MakeValue(parts[2]);
    cycle.answers.push_back(*std::move(answer));
    return true;
  }

  bool AddFailure(ScriptCycle& cycle, const std::vector<FormId>& parts) {
    if (!IsCall(parts[1]) || tree_.kind(parts[2]) != FormKind::kString) return false;
    std::optional<ScriptAnswer> answer = CallOf(parts[1]);
    if (!answer) return true;
    answer->failure = tree_.Unquoted(parts[2]);
    cycle.answers.push_back(*std::move(answer));
    return true;
  }

  bool IsCall(FormId form) const {
    return tree_.kind(form) == FormKind::kCall && tree_.at(form).first_child != kNoForm;
  }

  /// Nothing where it is no function of a world, which is reported.
  std::optional<ScriptAnswer> CallOf(FormId call) {
    const std::vector<FormId> words = tree_.Children(call);
    if (!IsName(words[0])) return std::nullopt;
    ScriptAnswer answer;
    answer.function = Function(tree_.Folded(words[0]), words.size() - 1);
    const Signature& known = script_.functions[answer.function];
    if (words.size() - 1 < known.least || words.size() - 1 > known.most) {
      Complain(call, "other answers of the script take another number of arguments");
    }
    for (std::size_t i = 1; i < words.size(); ++i) answer.arguments.push_back(MakeValue(words[i]));
    return answer;
  }

  bool AddUpdate(ScriptCycle& cycle, const std::vector<FormId>& parts) {
    if (tree_.kind(parts[1]) != FormKind::kList || tree_.kind(parts[2]) != FormKind::kList ||
        !IsGround(parts[2])) {
      return false;
    }
    const Value pattern = MakeValue(parts[1]);
    const Value fact = MakeValue(parts[2]);
    cycle.updated.emplace_back(pattern, fact);
    return !pattern.is_none() && !fact.is_none();
  }

  bool AddExpectation(ScriptCycle& cycle, const std::vector<FormId>& parts) {
    cycle.expected.emplace();
    for (std::size_t i = 1; i < parts.size(); ++i) {
      const bool call = tree_.kind(parts[i]) == FormKind::kCall;
      std::string text = call ? CallText(parts[i]) : tree_.Folded(parts[i]);
      if (!call && text != "true" && text != "false" && text != "fault") return false;
      cycle.expected->push_back(std::move(text));
    }
    return true;
  }

  std::string CallText(FormId call) {
    std::string text = "{";
    for (const FormId word : tree_.Children(call)) {
      if (text.size() > 1) text += ' ';
      text += ToString(MakeValue(word), names_);
    }
    return text + '}';
  }

  bool IsGround(FormId form) const {
    const FormKind kind = tree_.kind(form);
    if (kind == FormKind::kVariable || kind == FormKind::kCall) return false;
    const std::vector<FormId> parts = Parts(form);
    return std::all_of(parts.begin(), parts.end(), [this](FormId f) { return IsGround(f); });
  }

  Value MakeValue(FormId form) {
    const Form& at = tree_.at(form);
    switch (at.kind) {
      case FormKind::kInteger:
        return Value::Integer(at.integer);
      case FormKind::kReal:
        return Value::Real(at.real);
      case FormKind::kString:
        return Value::String(names_.Intern(tree_.Unquoted(form)));
      case FormKind::kVariable:
        return {};
      case FormKind::kList: {
        std::vector<Value> items;
        for (const FormId part : Parts(form)) items.push_back(MakeValue(part));
        return script_.arena.MakeList(items);
      }
      case FormKind::kCall:
        Complain(form, "a call cannot stand here");
        return {};
      default:
        return Value::Symbol(names_.Intern(tree_.Folded(form)));
    }
  }

  const SourceTree& tree_;
  NamePool& names_;
  Reporter reporter_;
  WorldScript& script_;
};

}  // namespace

WorldScript ReadScript(std::string text, std::string file, NamePool& names, Findings& findings) {
  WorldScript script;
  ExtendScript(std::move(text), std::move(file), names, script, findings);
  return script;
}

void ExtendScript(std::string text, std::string file, NamePool& names, WorldScript& script,
                  Findings& findings) {
  const SourceTree tree = ReadForms(std::move(text), std::move(file), findings, kMaxScriptBytes);
  ScriptReader(tree, names, findings, script).Read();
}

std::string ScriptedWorld::Remedy(std::string_view function) const {
  const std::string name(function);
  return "let the script answer it, (answer {" + name + " ...} value), or declare it, (functions " +
         name + "): then it is False";
}

Value ScriptedWorld::Call(std::size_t function, std::span<const Value> arguments, Arena& /*arena*/,
                          NamePool& /*names*/) {
  const ScriptAnswer* const answer = answers_.Find(function, arguments);
  if (answer == nullptr) return {};
  if (answer->failure) throw std::runtime_error(*answer->failure);
  return answer->answer;
}

void ScriptedWorld::Begin(const ScriptCycle& cycle, FactStore& memory) {
  for (const ScriptAnswer& answer : cycle.answers) answers_.Set(answer);
  for (const Value& pattern : cycle.forgotten) memory.Forget(pattern);
  for (const auto& [pattern, fact] : cycle.updated) memory.Update(pattern, fact);
  for (const Value& fact : cycle.stored) memory.Store(fact);
}

std::string FailureItem(const std::string& call, std::string message) {
  // A string ends on its line.
  std::replace_if(
      message.begin(), message.end(),
      [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }, ' ');
  return "(fail " + call + ' ' + Quoted(message) + ')';
}

std::string ToString(const Act& act, const NamePool& names) {
  std::string text;
  for (const ActCall& call : act.calls) {
    text += CallText(names.Name(call.function), call.arguments, names);
  }
  return text;
}

std::vector<std::string> Outcome(const CycleResult& result, const NamePool& names) {
  std::vector<std::string> outcome;
  for (const Act& act : result.acts) outcome.push_back(ToString(act, names));
  if (result.environments > 0) outcome.emplace_back("true");
  if (outcome.empty()) outcome.emplace_back("false");
  if (result.fault_count > 0) outcome.emplace_back("fault");
  return outcome;
}

std::string CallsOf(const std::vector<std::string>& words) {
  std::string calls;
  for (const std::string& word : words) {
    if (IsAct(word)) calls += word;
  }
  return calls;
}

bool Meets(const std::vector<std::string>& outcome, const std::vector<std::string>& expected) {
  const auto has = [](const std::vector<std::string>& words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  const bool same_truth = expected.empty() || has(outcome, "true") == has(expected, "true");
  return CallsOf(outcome) == CallsOf(expected) && same_truth &&
         (has(outcome, "fault") || !has(expected, "fault"));
}

}  // namespace latchwork::icarus

// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/language/finding.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace latchwork::icarus {

namespace {

/// Whether the comment, `; allow I017 I020`, names this code.
bool Waives(std::string_view comment, std::string_view code) {
  const std::size_t word = comment.find_first_not_of("; \t");
  if (word == std::string_view::npos || !comment.substr(word).starts_with("allow ")) return false;
  return Fold(comment).find(Fold(code)) != std::string::npos;
}

/// Whether the comment stands within the form of the top level, or behind its end, that holds the
/// place: where the formatter may have moved it.
bool StandInOneForm(const SourceTree& tree, const Comment& comment,
                    const logic::SourcePlace& place) {
  return std::any_of(tree.roots.begin(), tree.roots.end(), [&](FormId root) {
    const Form& form = tree.at(root);
    const logic::SourcePlace begin = tree.PlaceAt(form.line, 1);
    return begin.file == place.file && begin.line <= place.line &&
           place.line <= begin.line + (form.end_line - form.line) && form.line <= comment.line &&
           comment.line <= form.end_line;
  });
}

bool IsWaived(const SourceTree& tree, const Finding& finding) {
  if (finding.severity == Severity::kError) return false;
  return std::any_of(tree.comments.begin(), tree.comments.end(), [&](const Comment& comment) {
    const logic::SourcePlace at = tree.PlaceAt(comment.line, 1);
    const logic::SourcePlace& place = finding.diagnostic.place;
    const bool near = at.file == place.file && at.line + 1 == place.line;
    return Waives(tree.Text(comment), Info(finding.code).name) &&
           (near || StandInOneForm(tree, comment, place));
  });
}

}  // namespace

std::string Format(const Finding& finding) {
  const std::string_view severity = finding.severity == Severity::kError ? "error" : "warning";
  const std::string label =
      std::string(severity) + '[' + std::string(Info(finding.code).name) + ']';
  std::string text = logic::Format(finding.diagnostic, label);
  if (finding.note) text += logic::Format(*finding.note, "note");
  return text;
}

bool HasErrors(const Findings& findings) {
  return std::any_of(findings.begin(), findings.end(),
                     [](const Finding& f) { return f.severity == Severity::kError; });
}

logic::Diagnostics ErrorsOf(const Findings& findings) {
  logic::Diagnostics errors;
  for (const Finding& finding : findings) {
    if (finding.severity != Severity::kError) continue;
    errors.push_back(finding.diagnostic);
    errors.back().message =
        '[' + std::string(Info(finding.code).name) + "] " + finding.diagnostic.message;
  }
  return errors;
}

void Reporter::Add(Code code, FormId form, std::string message, std::string hint) {
  const Form& at = tree_.at(form);
  AddAt(code, at.begin, at.line, at.column, std::move(message), std::move(hint));
}

void Reporter::AddAt(Code code, std::uint32_t offset, std::uint32_t line, std::uint32_t column,
                     std::string message, std::string hint) {
  dropped_ = full();
  if (dropped_) return;
  Finding finding;
  finding.code = code;
  finding.severity = Info(code).severity;
  finding.diagnostic.place = tree_.PlaceAt(line, column);
  finding.diagnostic.message = std::move(message);
  finding.diagnostic.hint = std::move(hint);
  finding.diagnostic.excerpt = tree_.LineAt(offset);
  findings_.push_back(std::move(finding));
}

void Reporter::Note(FormId form, std::string message) {
  if (dropped_ || findings_.empty()) return;
  logic::Diagnostic note;
  note.place = tree_.Place(form);
  note.message = std::move(message);
  note.excerpt = tree_.LineAt(tree_.at(form).begin);
  findings_.back().note = std::move(note);
}

void MoveTo(const logic::SourcePlace& place, Findings& findings) {
  const auto move = [&](logic::Diagnostic& diagnostic) {
    logic::SourcePlace& at = diagnostic.place;
    if (at.line == 1) {
      at.column += place.column - 1;
      diagnostic.excerpt.insert(0, place.column - 1, ' ');
    }
    at.file = place.file;
    at.line += place.line - 1;
  };
  for (Finding& finding : findings) move(finding.diagnostic);
}

void Settle(const SourceTree& tree, Findings& findings) {
  std::erase_if(findings, [&](const Finding& finding) { return IsWaived(tree, finding); });
  std::stable_sort(findings.begin(), findings.end(), [](const Finding& a, const Finding& b) {
    const auto key = [](const Finding& f) {
      const logic::SourcePlace& place = f.diagnostic.place;
      return std::tuple<std::string_view, std::uint32_t, std::uint32_t, Code>(
          place.file, place.line, place.column, f.code);
    };
    return key(a) < key(b);
  });
}

}  // namespace latchwork::icarus

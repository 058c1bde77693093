// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/swipl/engine_text.h"

#include <string>

namespace latchwork::swipl {
namespace {

// A goal p(X) of predicate number 3 is called as p3(X, Depth, Ancestors), its denial as n3. Global
// variables: what backtracking undoes (b_) is `closing`, `level`, `pending` (delayed goals) and
// `resting` (assumptions of this proof); what it does not (nb_) is all else.
constexpr std::string_view kSearch = R"PL(
main :- forall(tabled(P), table(P)), nb_setval(called, 0), say(ready), flush_output, repeat, read(C),
    ( C == end_of_file -> halt
    ; catch(command(C), E, trouble(E)), flush_output, fail ).
trouble(error(resource_error(_), _)) :- !, say(done(memory, 0, false)).
trouble(E) :- say(failed), print_message(error, E).
% One call, so that no limit ends it within a line.
say(T) :- write_term(T, [quoted(true), ignore_ops(true), nl(true)]).

command(facts(Old, Rows)) :- retractall(Old), forall(member(R, Rows), assertz(R)).
command(decide(Depth, Calls, Few)) :- within(Calls, decide(Depth, Few)).
command(admit(Depth, Calls, Items)) :- reset, nb_setval(deepest, Depth),
    statistics(inferences, I0), Last is I0 + Calls,
    forall(member(Item, Items), admit(Item, Depth, Last)), say(done(none, 0, false)).

within(Calls, Goal) :-
    reset, statistics(inferences, I0),
    call_with_inference_limit(once((Goal ; true)), Calls, R),
    statistics(inferences, I1), I is min(I1 - I0, Calls), nb_getval(bound, B),
    ( R == inference_limit_exceeded -> End = inferences ; End = none ),
    say(done(End, I, B)).
reset :- abolish_all_tables,
    trie_new(Closed), nb_setval(closed, Closed), trie_new(Rows), nb_setval(computed, Rows),
    trie_new(With), nb_setval(failed_closing, With), trie_new(Without),
    nb_setval(failed_plain, Without), nb_setval(assumed, 0), nb_setval(asked, []),
    nb_setval(bound, false), nb_setval(undetermined, false), nb_setval(cut, false),
    nb_setval(cuts, 0), b_setval(pending, 0), b_setval(resting, []), b_setval(level, none),
    b_setval(closing, true).

decide(Depth, Few) :- nb_setval(deepest, Depth), Few > 0, denial(J, D, Call), refuted(Depth, Few, D, Call), !,
    say(inconsistent(J)).
decide(Depth, _) :- forall(goal(G, All, Atom, D, Call), decide_goal(Depth, G, All, Atom, D, Call)).
refuted(Depth, Few, D, Call) :-
    call_with_inference_limit(plainly(search(Depth, D, Call, true, End)), Few, R),
    in_full(R), End == accepted.
% What a limit broke off left notes of goals and calls that nobody works at any more.
in_full(inference_limit_exceeded) :- !, reset, say(anew), fail.
in_full(_).
plainly(Goal) :- b_setval(closing, false), once(Goal), b_setval(closing, true).
% Rows are computed once, for denials and for goals.
with_closing(Goal) :-
    b_getval(closing, Was), b_setval(closing, true), once(Goal), b_setval(closing, Was).
decide_goal(Depth, G, All, Atom, D, Call) :-
    trie_new(Known), nb_setval(undetermined, false),
    search(Depth, D, Call, accept(G, All, Atom, Known), End),
    say(end(G, End)).
accept(G, All, Atom, Known) :-
    trie_insert(Known, Atom, 1), nb_getval(depth, L), b_getval(resting, R),
    ( ground(Atom) -> say(concluded(G, Atom, L, R)), All == false ; say(everything(Atom)), fail ).
admit(item(_, Row, _, _, _), _, Last) :- statistics(inferences, Now), Now >= Last, !, assertz(Row).
admit(item(I, Row, Goal, D, Call), Depth, Last) :- statistics(inferences, Now), Calls is Last - Now,
    call_with_inference_limit(plainly(search(Depth, D, Call, true, End)), Calls, R),
    ( in_full(R), End == accepted -> offended(Goal, J), say(offends(I, J))
    ; assertz(Row), reset ).
% Which rule it was that the denial was proved with at last.
offended(Goal, J) :- nth_clause(Goal, J, Ref), clause(Goal, Body, Ref), plainly(call(Body)), !.
offended(_, 0).

% Levels of depth, each searched anew, until one is complete.
search(Depth, D, Call, Accept, End) :-
    b_getval(level, Outer), b_getval(pending, P), b_getval(resting, R), nb_getval(cut, Cut),
    ( nb_current(depth, Deep) -> true ; Deep = 0 ),
    b_setval(pending, 0), b_setval(resting, []),
    levels(1, Depth, D, Call, Accept, End),
    b_setval(level, Outer), b_setval(pending, P), b_setval(resting, R), nb_setval(cut, Cut),
    nb_setval(depth, Deep).
levels(L, Depth, D, Call, Accept, End) :-
    trie_new(Cut), trie_new(Full), trie_new(Proved), b_setval(level, level(Cut, Full, Proved)),
    nb_setval(cut, false), nb_setval(depth, L),
    ( \+ \+ ( D = L, call(Call), settled, call(Accept) ) -> End = accepted
    ; complete(Cut, Full, Proved) -> nb_getval(undetermined, U), ended(U, End)
    ; L < Depth -> L1 is L + 1, levels(L1, Depth, D, Call, Accept, End)
    ; End = depth ).
ended(true, undetermined).
ended(false, exhausted).
settled :- b_getval(pending, N), ( N =:= 0 -> true ; nb_setval(undetermined, true), fail ).
% Every goal that was cut off was searched in full elsewhere on the level, without success.
complete(Cut, Full, Proved) :-
    nb_getval(cut, false),
    \+ ( trie_gen(Cut, K), \+ ( trie_lookup(Full, K, _), \+ trie_lookup(Proved, K, _) ) ).

% Goals whose failure depends on nothing but their depth.
memo(K, Goal, D) :- b_getval(pending, 0), !, memory(F), memo(F, K, Goal, D).
memo(_, Goal, _) :- call(Goal).
memory(F) :- b_getval(closing, true), !, nb_getval(failed_closing, F).
memory(F) :- nb_getval(failed_plain, F).
memo(F, K, _, D) :- trie_lookup(F, K, Within), D =< Within, !,
    Within < 1000000000, cut_off(K), fail.
memo(F, K, Goal, D) :- nb_getval(cuts, C), ground(K), !,
    ( call(Goal) -> proved(K) ; failed(F, K, D, C), fail ).
memo(F, K, Goal, D) :- nb_getval(cuts, C), copy_term(K, Kept),
    ( call(Goal) *-> proved(Kept) ; failed(F, K, D, C), fail ).
proved(K) :- b_getval(level, level(_, _, Proved)), trie_update(Proved, K, 1).
failed(_, _, _, _) :- nb_getval(undetermined, true), !.
failed(F, K, D, C) :-
    b_getval(level, level(_, Full, _)), ( D > 0 -> trie_update(Full, K, 1) ; true ),
    nb_getval(cuts, C1), ( C1 =:= C -> Within = 1000000000 ; Within = D ),
    trie_update(F, K, Within).
cut_off(K) :- b_getval(pending, 0), !, count_cut,
    b_getval(level, level(Cut, _, _)), trie_update(Cut, K, 1).
cut_off(_) :- cut_off.
cut_off :- count_cut, nb_setval(cut, true).
count_cut :- nb_getval(cuts, C), C1 is C + 1, nb_setval(cuts, C1).
% Predicates that make no terms: their answers, in an order that does not depend on the machine.
answers(K) :- copy_term_nat(K, C), findall(C, C, Found), sort(Found, Sorted), member(K, Sorted).
regular(G, Up) :- \+ ( member(A, Up), A == G ).

% Literals that wait until they are ground.
delay(Vs, Goal) :- b_getval(pending, N), N1 is N + 1, b_setval(pending, N1),
    when(ground(Vs), woken(Goal)).
woken(Goal) :- b_getval(pending, N), N1 is N - 1, b_setval(pending, N1), call(Goal).
)PL";

constexpr std::string_view kOracles = R"PL(
close(Atom, Bound, D, Call) :- b_getval(closing, true), nb_getval(closed, T),
    ( trie_lookup(T, Atom, Known) -> true ; close(T, Atom, Bound, D, Call, Known) ),
    rests(Known).
close(T, Atom, Bound, D, Call, Known) :-
    trie_update(T, Atom, open), nb_getval(undetermined, U), nb_setval(undetermined, false),
    ( Bound =:= 0 -> nb_getval(deepest, Depth) ; Depth = Bound ),
    search(Depth, D, Call, true, End), nb_setval(undetermined, U),
    ( End == undetermined -> Known = open
    ; nb_getval(assumed, I), I1 is I + 1, nb_setval(assumed, I1), say(assumed(End, Atom)),
      ( End == accepted -> Known = no ; Known = yes(I) ) ),
    trie_update(T, Atom, Known).
rests(yes(I)) :- rest_on(I).
rests(open) :- nb_setval(undetermined, true), fail.
rest_on(I) :- b_getval(resting, R), ( memberchk(I, R) -> true ; b_setval(resting, [I|R]) ).

attached(A, Ins, Outs) :- rows(A, Ins, Rows, Rest), member(Outs, Rows), rest_on_all(Rest).
unattached(A, Ins, Outs) :- rows(A, Ins, Rows, Rest), \+ memberchk(Outs, Rows), rest_on_all(Rest).
rest_on_all(Rest) :- forall_once(Rest).
forall_once([]).
forall_once([I|Is]) :- rest_on(I), forall_once(Is).
rows(A, Ins, Rows, Rest) :- nb_getval(computed, T),
    ( trie_lookup(T, k(A, Ins), Known) -> true
    ; trie_update(T, k(A, Ins), open),
      nb_getval(called, N0), N is N0 + 1, nb_setval(called, N),
      say(call(N, A, Ins)), flush_output, attend(N, [], Rows0, Rest0),
      Known = rows(Rows0, Rest0), trie_update(T, k(A, Ins), Known) ),
    ( Known = rows(Rows, Rest) -> true ; nb_setval(undetermined, true), fail ).
attend(N, Rest0, Rows, Rest) :- read(C), attend(C, N, Rest0, Rows, Rest).
% Replies to calls that a limit broke off are still in the pipe.
attend(rows(M, _), N, Rest0, Rows, Rest) :- M \== N, !, attend(N, Rest0, Rows, Rest).
attend(ask(M, _, _, _, _), N, Rest0, Rows, Rest) :- M \== N, !, attend(N, Rest0, Rows, Rest).
attend(rows(_, Rows), _, Rest, Rows, Rest).
attend(ask(N, Depth, Values, D, Call), N, Rest0, Rows, Rest) :-
    trie_new(Known), nb_getval(asked, Outer), nb_setval(asked, Rest0),
    with_closing(search(Depth, D, Call, answer(Values, Known), End)),
    ( End == depth -> nb_setval(bound, true) ; true ),
    nb_getval(asked, Rest1), nb_setval(asked, Outer),
    say(answered(End)), flush_output, attend(N, Rest1, Rows, Rest).
answer(Values, Known) :- trie_insert(Known, Values, 1),
    ( ground(Values) -> say(answer(Values)), b_getval(resting, R), nb_getval(asked, A),
      union(R, A, All), nb_setval(asked, All)
    ; nb_setval(bound, true) ), fail.

differ(U, A, B) :- A \== B, differ_terms(U, A, B).
differ_terms(_, A, B) :- number(A), number(B), !, X is float(A), Y is float(B), X =\= Y.
differ_terms(_, A, B) :- known(A), known(B), !.
differ_terms(true, A, B) :- ( plain(A) ; plain(B) ), !.
differ_terms(true, A, B) :- functor(A, F, N), functor(B, F, N), !,
    arg(I, A, X), arg(I, B, Y), differ(true, X, Y), !.
differ_terms(true, _, _).
known(A) :- number(A).
known(d(_)).
plain(A) :- \+ compound(A).
plain(d(_)).
)PL";

constexpr std::string_view kArithmetic = R"PL(
compares(Op, A, B) :- number(A), number(B),
    ( integer(A), integer(B) -> holds(Op, A, B)
    ; X is float(A), Y is float(B), holds(Op, X, Y) ).
holds(less, A, B) :- A < B.
holds(lesseq, A, B) :- A =< B.
holds(greater, A, B) :- A > B.
holds(greatereq, A, B) :- A >= B.
is_int(A) :- number(A), ( integer(A) -> true ; A =:= floor(A) ).
is_real(A) :- number(A).
not_compare(Op, A, B) :- number(A), number(B), \+ compares(Op, A, B).
not_is_int(A) :- number(A), \+ is_int(A).

value(F, A, B, V) :- number(A), number(B),
    ( integer(A), integer(B) -> whole(F, A, B, V)
    ; X is float(A), Y is float(B), catch(real(F, X, Y, V0), _, fail), tidy(V0, V) ).
value(F, A, V) :- number(A),
    ( integer(A) -> whole(F, A, V)
    ; catch(real(F, A, V0), _, fail), tidy(V0, V) ).
tidy(V, V) :- integer(V), !, fits(V).
tidy(V0, V) :- ( V0 =:= 0.0 -> V = 0.0 ; V = V0 ).
fits(V) :- V >= -9223372036854775808, V =< 9223372036854775807.
whole(sum, A, B, V) :- V is A + B, fits(V).
whole(difference, A, B, V) :- V is A - B, fits(V).
whole(product, A, B, V) :- V is A * B, fits(V).
whole(min, A, B, V) :- V is min(A, B).
whole(max, A, B, V) :- V is max(A, B).
whole(quotient, A, B, V) :- B =\= 0,
    ( A mod B =:= 0 -> V is A // B, fits(V) ; V is float(A) / float(B) ).
whole(quotient_e, A, B, V) :- B =\= 0, V is (A - A mod abs(B)) // B, fits(V).
whole(remainder_e, A, B, V) :- B =\= 0, V is A mod abs(B).
real(sum, A, B, V) :- V is A + B.
real(difference, A, B, V) :- V is A - B.
real(product, A, B, V) :- V is A * B.
real(min, A, B, V) :- V is min(A, B).
real(max, A, B, V) :- V is max(A, B).
real(quotient, A, B, V) :- B =\= 0.0, V is A / B.
real(remainder_e, A, B, V) :- B =\= 0.0, X is rational(A), Y is abs(rational(B)),
    V is float(X - floor(X rdiv Y) * Y).
real(quotient_e, A, B, V) :- real(remainder_e, A, B, R), X is (A - R) / B, real(round, X, V).
whole(uminus, A, V) :- V is -A, fits(V).
whole(abs, A, V) :- V is abs(A), fits(V).
whole(to_real, A, V) :- V is float(A).
whole(to_int, A, A).
whole(floor, A, A).
whole(ceiling, A, A).
whole(round, A, A).
whole(truncate, A, A).
real(uminus, A, V) :- V is -A.
real(abs, A, V) :- V is abs(A).
real(to_real, A, A).
real(to_int, A, V) :- V is floor(A).
real(floor, A, V) :- V is float(floor(A)).
real(ceiling, A, V) :- V is float(ceiling(A)).
real(truncate, A, V) :- V is float(truncate(A)).
real(round, A, V) :- F is floor(A), Over is A - F,
    ( Over < 0.5 -> V is float(F) ; Over > 0.5 -> V is float(F + 1)
    ; F mod 2 =:= 0 -> V is float(F) ; V is float(F + 1) ).
)PL";

}  // namespace

std::string_view EngineText() {
  static const std::string text =
      std::string(kSearch) + std::string(kOracles) + std::string(kArithmetic);
  return text;
}

}  // namespace latchwork::swipl

p(X) :- q(X).
fof(a, axiom, p -> q).
fof(b, axiom, p && q).
thf(c, axiom, p @ q).

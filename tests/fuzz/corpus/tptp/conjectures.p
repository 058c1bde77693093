fof(a, conjecture, p).
fof(b, conjecture, ! [X] : q(X)).
fof(c, axiom, r).

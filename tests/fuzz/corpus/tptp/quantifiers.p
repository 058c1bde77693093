fof(a, axiom, ! [X, Y] : ? [Z] : (p(X, Z) <=> (q(Y) & r(Z)))).
fof(b, conjecture, ? [X] : p(X, X)).

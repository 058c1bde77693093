fof(a, axiom, p(X)).

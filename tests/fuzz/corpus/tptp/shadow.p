fof(a, axiom, ! [X] : (? [X] : p(X) & q(X))).
fof(b, axiom, ! [X, X] : p(X)).

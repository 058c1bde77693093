fof(a, axiom, ! [X] : (f(X) = X | g(X) != f(a))).

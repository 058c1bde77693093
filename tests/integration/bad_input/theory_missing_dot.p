fof(a, axiom, p(x))
fof(b, axiom, q(x)).

fof(a, axiom, p('b)).
fof(b, axiom, "c).

fof(a, axiom, (p => q)).
fof(b, axiom, p => => q).
cnf(c, axiom, p & q).
fof(d, conjecture, q).

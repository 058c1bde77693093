fof(a, axiom, p(99999999999999999999)).
fof(b, axiom, p(1e999)).
fof(c, axiom, p(1/2)).

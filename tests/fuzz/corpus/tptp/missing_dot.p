fof(a, axiom, p)
fof(b, axiom, (q).
fof(c, axiom, & ).

fof(a, axiom, p & q | r).
fof(b, axiom, p => q => r).
fof(c, axim, p).
fof(d, axiom, Pred(a)).

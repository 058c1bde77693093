fof('a, axiom, p).

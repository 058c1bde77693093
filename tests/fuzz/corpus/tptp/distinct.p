fof(a, axiom, $distinct(a, b, "c", 4)).

tff(p_type, type, p: ($int * $real) > $o).
tff(n, axiom, ! [X: $int, Y: $real] : (p(X, Y) => $less(X, $sum(1, 2)))).

cnf(c1, axiom, p(X) | ~ q(X, f(a))).
cnf(c2, negated_conjecture, ( ~ (p(X)) | a != X )).
cnf(3, axiom, $false).

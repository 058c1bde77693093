fof(a, axiom, $lesseq($product(2, -3), $quotient(1.5e-3, +7))).
fof(b, axiom, ! [X] : $greater($to_real(X), $uminus(0.5))).

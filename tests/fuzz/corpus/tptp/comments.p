% one
/* two
 **/fof(n, axiom, % three
 p).

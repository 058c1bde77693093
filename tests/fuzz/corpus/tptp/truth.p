fof(a, axiom, $true | ~ $false).
fof(b, axiom, ! [X] : ($true <=> (p(X) & $false))).
fof(c, conjecture, $false).

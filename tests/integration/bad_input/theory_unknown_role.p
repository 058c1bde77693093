fof(a, axoim, p).
fof(b, conjecure, p).

include('nowhere.ax').
fof(b, conjecture, p).

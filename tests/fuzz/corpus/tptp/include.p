include('nowhere.ax').
include('nowhere.ax', [a, 'B', 3]).
include('/dev/zero', *).

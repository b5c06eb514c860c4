source agent.soar
run 2
wm add s1 ^note |a b|
wm add s1 ^note "a b"
wm add s1 ^note z99
wm add s1 ^z99 note
wm add z99 ^note here
wm add s1 ^note <x>
wm add s1 ^note <s>
wm add s1 note ^here
wm add s1 ^^note here
wm add s1 ^part *
wm add s1 ^* *
wm add s1 ^count 7
wm add s1 operator * +
wm add s1 note here +
wm add s1 note here -
print s1
preferences s1 operator
run 1
print s1
wm remove x
wm remove 1.5
wm remove 0

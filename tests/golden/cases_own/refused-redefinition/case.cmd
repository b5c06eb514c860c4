source agent.soar
run -p 2
sp {first (state <s> ^superstate nil) --> (<s> ^first u }
sp {second (state <s> ^superstate nil)}
sp {third 99999999999999999999999 (state <s> ^superstate nil) --> (<s> ^third u)}
sp {fourth (s1 ^superstate nil) --> (<s> ^fourth u)}
sp {fifth}
print
run -p 6
print s1
sp {first (state <s> ^superstate nil) --> (<s> ^first t)}
sp {first (state <s> ^superstate nil) --> (<s> ^first (unheard-of t))}
sp {sixth (state <s> ^superstate nil) --> (s1 ^a b ^c d)}
sp {sixth (state <s> ^superstate nil) --> (S1)}
sp {sixth (state <s> ^superstate nil) --> (s1 b)}
sp {sixth (state <s> ^superstate nil) --> (<s> ^a (^b c))}
sp {sixth (state <s> ^superstate nil) --> (^b c)}
sp {sixth (state <s> ^superstate nil) --> (<s> ^a (s1))}
sp {sixth (state <s> ^superstate nil) --> (<s> ^a ())}
sp {sixth (state <s> ^superstate nil) --> (<s> ^a (/ 1 (* 2 3)))}
print --full sixth
print

# excise --chunks excises justifications, too
sp {p (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name a)}
sp {r (state <s> ^superstate <ss>) (<ss> ^operator.name a) --> (<ss> ^res t)}
run 3
print -j
print -d 1 s1
excise -c
print -d 1 s1
run 1
print -d 1 s1
print -j
memories -j
memories
excise --all

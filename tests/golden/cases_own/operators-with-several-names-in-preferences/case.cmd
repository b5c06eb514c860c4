# Operators are printed with all their names, and those that evaluate objects with these.
sp {test*one (state <s> ^superstate nil) --> (<s> ^operator <o> + > ^operator <p> +) (<o> ^name one two) (<p> ^name evaluate-object ^object <o>)}
sp {test*b (state <s> ^superstate nil) --> (<s> ^y <x>) (<x> ^name evaluate-object ^object <x>)}
run 1
preferences s1 operator
preferences s1 operator -n
watch 5
run 1

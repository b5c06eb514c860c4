# What follows from a justification that tested quiescence is not learned, either.
chunk always
sp {top (state <s> ^superstate nil) --> (<s> ^task tidy)}
sp {mid*op (state <s> ^superstate.superstate nil) --> (<s> ^operator.name look)}
sp {low*quiet (state <s> ^quiescence t ^superstate <m>) (<m> ^operator.name look ^superstate.task <t>) --> (<m> ^calm <t>)}
sp {mid*result (state <s> ^calm <t> ^superstate <ss>) --> (<ss> ^found <t>)}
trace 1
trace --learning fullprint
run 5

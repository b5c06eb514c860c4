# Errors of right-hand sides are printed even where rules may not write.
output agent-writes off
sp {a (state <s> ^superstate nil) --> (<s> ^x none) (write |unheard| (crlf))}
sp {b (state <s> ^x <b>) --> (<b> ^prev none +)}
sp {c (state <s> ^x <b>) --> (<s> ^y (/ 3 0)) (<s> ^z (+ a b)) (<s> ^u (div 3 0))}
run 2
output agent-writes on
init-soar
run 2

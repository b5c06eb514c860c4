# ten are listed
watch 0
chunk always
explain all on
sp {init (state <s> ^superstate nil) --> (<s> ^name top ^num 1 ^k 2)}
sp {rule*a (state <s> ^superstate <ss>) (<ss> ^num <n>) --> (<ss> ^of-a <n>)}
sp {rule*b (state <s> ^superstate <ss>) (<ss> ^num <n>) --> (<ss> ^of-b <n>)}
sp {rule*c (state <s> ^superstate <ss>) (<ss> ^num <n>) --> (<ss> ^of-c <n>)}
sp {rule*d (state <s> ^superstate <ss>) (<ss> ^num <n>) --> (<ss> ^of-d <n>)}
sp {rule*e (state <s> ^superstate <ss>) (<ss> ^num <n>) --> (<ss> ^of-e <n>)}
sp {rule*f (state <s> ^superstate <ss>) (<ss> ^num <n>) --> (<ss> ^of-f <n>)}
sp {rule*g (state <s> ^superstate <ss>) (<ss> ^num <n>) --> (<ss> ^of-g <n>)}
sp {rule*h (state <s> ^superstate <ss>) (<ss> ^num <n>) --> (<ss> ^of-h <n>)}
sp {rule*i (state <s> ^superstate <ss>) (<ss> ^num <n>) --> (<ss> ^of-i <n>)}
sp {rule*j (state <s> ^superstate <ss>) (<ss> ^num <n>) --> (<ss> ^of-j <n>)}
sp {rule*k (state <s> ^superstate <ss>) (<ss> ^num <n>) --> (<ss> ^of-k <n>)}
sp {rule*l (state <s> ^superstate <ss>) (<ss> ^num <n>) --> (<ss> ^of-l <n>)}
run 2
explain

(* Merge sort and removal of equals, without recursion on the machine's stack.
   The proof needs one fact: nothing is lost and nothing is made. That the list is in order is not needed. *)
Require Import List Permutation.
Import ListNotations.

Section Sort.
Context {A : Type} (compare : A -> A -> comparison).

Fixpoint merge (l1 : list A) : list A -> list A -> list A :=
  fix merge_l1 (l2 acc : list A) : list A :=
    match l1, l2 with
    | [], _ => rev_append acc l2
    | _, [] => rev_append acc l1
    | x :: t1, y :: t2 =>
      match compare x y with
      | Gt => merge_l1 t2 (y :: acc)
      | _ => merge t1 l2 (x :: acc)
      end
    end.

Fixpoint merge_pairs (ls acc : list (list A)) : list (list A) :=
  match ls with
  | a :: b :: r => merge_pairs r (merge a b [] :: acc)
  | [a] => a :: acc
  | [] => acc
  end.

Fixpoint merge_all (rounds : nat) (ls : list (list A)) : list A :=
  match rounds, ls with
  | _, [] => []
  | _, [a] => a
  | O, a :: r => fold_left (fun acc l => rev_append l acc) r a
  | S n, _ => merge_all n (merge_pairs ls [])
  end.

Fixpoint singles (l : list A) (acc : list (list A)) : list (list A) :=
  match l with
  | [] => acc
  | x :: r => singles r ([x] :: acc)
  end.

(* Forty rounds are enough for 2^40 items. *)
Definition sort (l : list A) : list A := merge_all 40 (singles l []).

Fixpoint distinct (l acc : list A) : list A :=
  match l with
  | [] => acc
  | x :: r =>
    match acc with
    | y :: _ => match compare x y with Eq => distinct r acc | _ => distinct r (x :: acc) end
    | [] => distinct r [x]
    end
  end.

Fixpoint equal (l m : list A) : bool :=
  match l, m with
  | [], [] => true
  | x :: l', y :: m' => match compare x y with Eq => equal l' m' | _ => false end
  | _, _ => false
  end.

Definition same_set (l m : list A) : bool := equal (distinct (sort l) []) (distinct (sort m) []).

Lemma merge_permutes l1 : forall l2 acc, Permutation (merge l1 l2 acc) (acc ++ l1 ++ l2).
Proof.
  induction l1 as [|x t1 IH1]; intros l2; induction l2 as [|y t2 IH2]; intros acc; cbn [merge];
    rewrite ?rev_append_rev, ?app_nil_r.
  - rewrite <- Permutation_rev; cbn; rewrite ?app_nil_r; reflexivity.
  - rewrite <- Permutation_rev. reflexivity.
  - rewrite <- Permutation_rev. reflexivity.
  - assert (G : Permutation (merge (x :: t1) t2 (y :: acc)) (acc ++ (x :: t1) ++ y :: t2)).
    { etransitivity; [apply IH2|]. cbn [app].
      rewrite (Permutation_middle acc). apply Permutation_app_head.
      rewrite (Permutation_middle (x :: t1) t2 y). reflexivity. }
    assert (L : Permutation (merge t1 (y :: t2) (x :: acc)) (acc ++ (x :: t1) ++ y :: t2)).
    { etransitivity; [apply IH1|]. cbn [app]. apply (Permutation_middle acc). }
    destruct (compare x y); [exact L | exact L | exact G].
Qed.

Lemma merge_pairs_permutes n : forall ls acc, length ls <= n ->
  Permutation (concat (merge_pairs ls acc)) (concat acc ++ concat ls).
Proof.
  induction n as [|n IH]; intros ls acc H.
  - destruct ls; [|inversion H]. cbn. rewrite app_nil_r. reflexivity.
  - destruct ls as [|a [|b r]]; cbn [merge_pairs].
    + cbn. rewrite app_nil_r. reflexivity.
    + cbn. rewrite app_nil_r. apply Permutation_app_comm.
    + rewrite IH by (cbn in H; apply le_S_n in H; apply le_S_n; apply le_S; assumption).
      cbn [concat]. rewrite merge_permutes. cbn [app].
      rewrite (Permutation_app_comm (a ++ b)), <- !app_assoc. reflexivity.
Qed.

Lemma merge_all_permutes n : forall ls, Permutation (merge_all n ls) (concat ls).
Proof.
  induction n as [|n IH]; intros [|a [|b r]]; cbn [merge_all]; try (cbn; rewrite ?app_nil_r; reflexivity).
  - assert (G : forall (r : list (list A)) a, Permutation (fold_left (fun acc l => rev_append l acc) r a) (a ++ concat r)).
    { clear. induction r as [|l r IH]; intros a; cbn.
      - rewrite app_nil_r; reflexivity.
      - rewrite IH, rev_append_rev, <- Permutation_rev, app_assoc.
        apply Permutation_app_tail, Permutation_app_comm. }
    apply G.
  - rewrite IH, (merge_pairs_permutes _ _ _ (le_n _)). reflexivity.
Qed.

Lemma singles_permutes l : forall acc, Permutation (concat (singles l acc)) (concat acc ++ l).
Proof.
  induction l as [|x r IH]; intros acc; cbn.
  - rewrite app_nil_r; reflexivity.
  - rewrite IH. cbn. apply Permutation_middle.
Qed.

Lemma sort_in l x : In x (sort l) <-> In x l.
Proof.
  assert (P : Permutation (sort l) l).
  { unfold sort. rewrite merge_all_permutes, singles_permutes. reflexivity. }
  split; apply Permutation_in; [|symmetry]; assumption.
Qed.

Hypothesis compare_eq : forall x y, compare x y = Eq -> x = y.

Lemma distinct_in l : forall acc x, In x (distinct l acc) <-> In x acc \/ In x l.
Proof.
  induction l as [|a r IH]; intros acc x; cbn [distinct].
  - cbn; tauto.
  - destruct acc as [|y acc]; [rewrite IH; cbn; tauto|].
    destruct (compare a y) eqn:E; rewrite IH; cbn [In]; try tauto.
    apply compare_eq in E; subst; tauto.
Qed.

Lemma equal_eq l : forall m, equal l m = true -> l = m.
Proof.
  induction l as [|x l IH]; intros [|y m]; cbn; try easy.
  destruct (compare x y) eqn:E; try easy. intros H. apply compare_eq in E. f_equal; auto.
Qed.

Lemma same_set_in l m : same_set l m = true -> forall x, In x l <-> In x m.
Proof.
  intros H x. apply equal_eq in H.
  pose proof (distinct_in (sort l) [] x) as L. pose proof (distinct_in (sort m) [] x) as M.
  rewrite sort_in in L, M. rewrite H in L. cbn in L, M. tauto.
Qed.
End Sort.

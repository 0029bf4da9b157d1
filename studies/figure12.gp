# picture of figure12

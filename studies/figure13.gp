# picture of figure13
